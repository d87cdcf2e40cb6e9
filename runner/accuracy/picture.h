#pragma once
// An accuracy report as a picture: error over CPU time, both on logarithmic scales; each point is labelled
// with its time step.
#include "accuracy/accuracy.h"
#include "charts/chart.h"

namespace morula {

/// One line per series; what failed or is not resolved is not drawn. A run in which other cells live from
/// some time on is a hollow point by itself, with that time.
Drawing drawAccuracy(const AccuracyReport& report);

}  // namespace morula
