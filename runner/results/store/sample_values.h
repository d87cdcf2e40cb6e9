#pragma once
// The values of an asked measure in a sample.
#include <map>
#include <string>

#include "observation/asked_measure.h"
#include "store/records.h"

namespace morula {

/// The subject of a measured value: a cell, a pair with a < b, or the organism, for which a and b are the egg.
struct MeasuredThing {
  CellPath a, b;
  auto operator<=>(const MeasuredThing&) const = default;
};

/// Returns the sample's values of the measure for the cells that were asked for. They come from the columns, or from a
/// measure of record.measures with the same name or over all cells. `states`: the substances of each state in the
/// sample.
std::map<MeasuredThing, double> valuesIn(const Sample& sample, const AskedMeasure& measure,
                                         const std::map<StateId, std::string>& states);

/// Returns the mean of valuesIn over cells or pairs; absent if there are none.
std::optional<double> meanIn(const Sample& sample, const AskedMeasure& measure,
                             const std::map<StateId, std::string>& states);

}  // namespace morula
