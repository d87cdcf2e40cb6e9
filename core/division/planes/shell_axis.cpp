// Planes along the shell, whatever the cell's shape. Of equally long semi-axes x comes before y before z.
#include "base/error.h"
#include "division/planes/directions.h"

namespace morula {
namespace {

struct ShellAxis final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> shell = cell.shell();
    MORULA_CHECK(shell.has_value(), "division.plane shell-axis in a scene without a shell");
    const auto& [a, b, c] = *shell;
    return throughCentre(cell, a >= b && a >= c ? Vector{1, 0, 0} : b >= c ? Vector{0, 1, 0} : Vector{0, 0, 1});
  }
};

}  // namespace

const DivisionPlaneKind shellAxisPlane{
    .plane = DivisionPlane::shellAxis,
    .name = "shell-axis",
    .meaning = "the shell's longest semi-axis, with daughter A on its positive side",
    .needsLongShell = true,
    .make = makeFromChoice<ShellAxis>,
};

}  // namespace morula
