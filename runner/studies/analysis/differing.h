#pragma once
// Which conditions of a study to look at first.
#include <cstddef>
#include <vector>

#include "analysis/comparison.h"

namespace morula {

/// All conditions, those that differ most first: the two whose means are farthest apart, then each that is farthest from all
/// before it [Gonzalez 1985]. Far: the root of the sum of squared differences over the measures, each in standard deviations
/// of all its values. Among equals the earlier one; conditions without any value come last.
std::vector<std::size_t> byDifference(const StudyComparison& comparison);

}  // namespace morula
