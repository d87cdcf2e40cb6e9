#pragma once
// The numbers that measures can be, for the axes of charts.
#include "drawing/axis.h"
#include "observation/asked_measure.h"

namespace morula {

/// Returns the bounds of a measure in units of `factor` of the scene's: a share is 0 to 1, a count at least 0.
AxisBounds boundsOf(const AskedMeasure& measure, double factor = 1);

/// Returns the first clause of the measure's meaning; "" for counts, distances and what is made of two measures.
std::string shortMeaningOf(const AskedMeasure& measure);

}  // namespace morula
