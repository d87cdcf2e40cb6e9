#pragma once
// The values of an asked measure in a sample.
#include <map>
#include <string>

#include "simulation/asked_measure.h"
#include "store/records.h"

namespace morula {

/// A cell; or a pair, a < b; or the organism, where both are the egg.
struct MeasuredThing {
  CellPath a, b;
  auto operator<=>(const MeasuredThing&) const = default;
};

/// The values that the sample has, of the cells that were asked for: from its columns, or from what record.measures had
/// taken under the same name, or of all cells. `states`: the substances of each state in the sample.
std::map<MeasuredThing, double> valuesIn(const Sample& sample, const AskedMeasure& measure,
                                         const std::map<StateId, std::string>& states);

}  // namespace morula
