#pragma once
// A study's answer as a picture.
#include "analysis/comparison.h"
#include "charts/small_multiples.h"

namespace morula {

/// A panel a measure: all values of each condition, their mean and its interval; then, where there are time courses, a panel a
/// measure of the means over time. The first axis that is compared is told by colour and shape, the others by words.
SmallMultiples stripsOf(const StudyComparison& comparison);

}  // namespace morula
