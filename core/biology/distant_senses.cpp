// Senses of distant cells.
#include <algorithm>
#include <limits>

#include "base/maths.h"
#include "biology/sense.h"

namespace morula {
namespace {

/// Returns the distance [length] to the nearest counted cell; infinite without any.
double nearest(const CellContext& cell, const SenseParameters&, const CountsCell& counts) {
  double distance = std::numeric_limits<double>::infinity();
  for (const OtherCell& other : cell.otherCells())
    if (counts(*other.cell)) distance = std::min(distance, other.distance);
  return distance;
}

/// Returns the steady concentration c [1/length] of a substance that each counted cell releases at a rate of 4π D, and
/// that diffuses with D and decays with the rate k: D ∇²c = k c around a point gives c = e^(−r/λ)/r, with λ = √(D/k)
/// the range [Yukawa's potential; e.g. Wartlick, Kicheva & González-Gaitán 2009]. Infinite at r = 0.
double concentration(const CellContext& cell, const SenseParameters& sense, const CountsCell& counts) {
  double sum = 0;
  for (const OtherCell& other : cell.otherCells())
    if (counts(*other.cell)) sum += exponential(-other.distance / *sense.number) / other.distance;
  return sum;
}

Threshold distanceAtMost(const SenseParameters& sense) { return {.atMost = sense.number}; }

// clang-format off
constexpr SenseKindRow distantRows[] = {
    {.kind = SenseKind::near, .name = "near",
     .meaning = "The centre of another cell that holds `of` lies within this `distance` of the cell's centre",
     .needs = SenseNeeds::bodies, .of = {"of", true}, .number = {"distance", "length", true},
     .measure = nearest, .threshold = distanceAtMost},
    {.kind = SenseKind::diffusion, .name = "diffusion",
     .meaning = "Concentration of a signal that cells with `of` release, and that diffuses and decays with this "
                "`range`: the sum of e^(−r/range)/r over these cells without the cell itself, r between centres",
     .unit = "1/length", .needs = SenseNeeds::bodies, .of = {"of", true}, .number = {"range", "length", true},
     .least = 0, .measure = concentration},
};
// clang-format on

}  // namespace

std::span<const SenseKindRow> distantSenses() { return distantRows; }

}  // namespace morula
