// Senses of the cell's own body.

#include "base/error.h"
#include "biology/physical_unit.h"
#include "biology/sense.h"

namespace morula {
namespace {

const PhysicalUnit& bodyOf(const CellContext& cell) {
  MORULA_CHECK(cell.physical(), "a cell without a body is not asked for it");
  return *cell.physical();
}

double volume(const CellContext& cell, const SenseParameters&, const CountsCell&) {
  return bodyOf(cell).getVolume() / bodyOf(cell).getRestVolume();
}

double pressure(const CellContext& cell, const SenseParameters&, const CountsCell&) {
  return bodyOf(cell).getPressure();
}

double age(const CellContext& cell, const SenseParameters&, const CountsCell&) { return cell.age(); }

double elongation(const CellContext& cell, const SenseParameters&, const CountsCell&) { return cell.elongation(); }

double shell(const CellContext& cell, const SenseParameters&, const CountsCell&) { return cell.shellShare(); }

double position(const CellContext& cell, const SenseParameters& sense, const CountsCell&) {
  return dot(bodyOf(cell).getShape().centre, sense.axis) / norm(sense.axis);
}

// clang-format off
constexpr SenseKindRow bodyRows[] = {
    {.kind = SenseKind::volume, .name = "volume",
     .meaning = "Its volume over what it would be if nothing pressed on it",
     .needs = SenseNeeds::bodies, .least = 0, .measure = volume},
    {.kind = SenseKind::pressure, .name = "pressure", .meaning = "Its inner pressure less the outer one",
     .unit = "force/length²", .needs = SenseNeeds::membrane, .measure = pressure},
    {.kind = SenseKind::age, .name = "age", .meaning = "The time since its birth", .unit = "time",
     .least = 0, .measure = age},
    {.kind = SenseKind::elongation, .name = "elongation",
     .meaning = "Its largest over its second largest extent, as the measure of that name; 1 of a ball",
     .needs = SenseNeeds::mesh, .least = 1, .measure = elongation},
    {.kind = SenseKind::shell, .name = "shell", .meaning = "The share of its surface that lies on the shell",
     .needs = SenseNeeds::shell, .least = 0, .most = 1, .measure = shell},
    {.kind = SenseKind::position, .name = "position",
     .meaning = "Where its centre is along an axis through the origin", .unit = "length",
     .needs = SenseNeeds::bodies, .takesAxis = true, .measure = position},
};
// clang-format on

}  // namespace

std::span<const SenseKindRow> bodySenses() { return bodyRows; }

}  // namespace morula
