#pragma once
// An accuracy report as a picture: error over CPU time, both on logarithmic scales; each point is labelled
// with its time step.
#include "accuracy/accuracy.h"
#include "image/image.h"

namespace morula {

/// Of series number i, counted from 0: no two of the first 24 are alike.
Colour seriesColour(std::size_t number);

/// One line per series; what failed or is not resolved is not drawn. A run in which other cells live from
/// some time on is a hollow point by itself, with that time.
Image drawAccuracy(const AccuracyReport& report);

}  // namespace morula
