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
     .meaning = "Area of the contact: force over pressure, of either cell's vertices where the surfaces overlap, if "
                "the area is at least 0.005 of the smaller cell's surface; for cells that stick, the mean of this "
                "area and of the area on which attraction acts, by pressure p and adhesion's stress 3 W/A, where A "
                "is one and a half reaches; for two balls the disc in which their surfaces meet",
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
     .meaning = "Time for which the two have touched, by samples: since the first sample of an unbroken row that "
                "ends with this one, 0 in the first; breaks between samples are not seen",
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
