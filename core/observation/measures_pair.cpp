// The measures of two cells that touch. To add one: a row here; measures on demand stand last.
#include <algorithm>

#include "observation/measures.h"
#include "observation/organism_measures.h"

namespace morula {
namespace {

using Value = std::optional<double>;

// clang-format off
constexpr PairMeasure ofPair[] = {
    {.name = "area", .unit = "length²",
     .meaning = "Of the contact: force over pressure, of either cell's vertices where the surfaces overlap, if it is 0.005 of the smaller one's surface at least; of cells "
                "that stick, the mean of that and of the area on which attraction acts, by pressure p and adhesion's stress 3 W/A, A one and a half reaches; of two "
                "balls the disc in which their surfaces meet",
     .needs = Needs::contact,
     .followsNumber = true, .get = [](const Touch& touch) -> Value { return touch.area; }},
    {.name = "contact_share", .meaning = "Area of the contact over the surface of the cell with less of it",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .followsNumber = true, .get = [](const Touch& touch) -> Value {
       return touch.area / std::min(touch.a.physical()->getShape().area, touch.b.physical()->getShape().area);
     }},
    {.name = "kinship",
     .meaning = "Generations from their youngest common ancestor down to the later of the two: 1 for sisters, 2 for cousins",
     .needs = Needs::contact, .taken = Taken::onDemand, .isWhole = true,
     .followsNumber = true, .get = [](const Touch& touch) -> Value {
       const CellPath &a = touch.a.path, &b = touch.b.path;
       return double(std::max(a.depth(), b.depth()) - commonDepth(a, b));
     }},
    {.name = "contact_duration", .unit = "time",
     .meaning = "Since the first of the samples in a row, this one the last, in which the two touch: 0 in the first, and after "
                "a sample without; what is between samples is not seen",
     .needs = Needs::contact, .taken = Taken::onDemand,
     .get = [](const Touch& touch) -> Value { return touch.duration; }},
};
// clang-format on

}  // namespace

template <>
std::span<const PairMeasure> measures<Touch>() {
  return ofPair;
}

}  // namespace morula
