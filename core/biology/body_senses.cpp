// Senses of the cell's own body.

#include "base/error.h"
#include "biology/physical_unit.h"
#include "biology/sense.h"

namespace morula {
namespace {

const PhysicalUnit& bodyOf(const CellContext& cell) {
  MORULA_CHECK(cell.physical(), "senses of the body are only for cells with a body");
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
     .meaning = "Volume of the cell over its volume at rest, if nothing pressed on it",
     .needs = SenseNeeds::bodies, .least = 0, .measure = volume},
    {.kind = SenseKind::pressure, .name = "pressure", .meaning = "Inner pressure of the cell minus the outer one",
     .unit = "force/length²", .needs = SenseNeeds::membrane, .measure = pressure},
    {.kind = SenseKind::age, .name = "age", .meaning = "Time since the birth of the cell", .unit = "time",
     .least = 0, .measure = age},
    {.kind = SenseKind::elongation, .name = "elongation",
     .meaning = "Largest over second largest extent of the cell, as the measure elongation; 1 for a ball",
     .needs = SenseNeeds::mesh, .least = 1, .measure = elongation},
    {.kind = SenseKind::shell, .name = "shell", .meaning = "Share of the cell's surface that lies on the shell",
     .needs = SenseNeeds::shell, .least = 0, .most = 1, .measure = shell},
    {.kind = SenseKind::position, .name = "position",
     .meaning = "Coordinate of the cell's centre along an axis through the origin", .unit = "length",
     .needs = SenseNeeds::bodies, .takesAxis = true, .measure = position},
};
// clang-format on

}  // namespace

std::span<const SenseKindRow> bodySenses() { return bodyRows; }

}  // namespace morula
