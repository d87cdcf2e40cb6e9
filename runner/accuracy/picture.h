#pragma once
// An accuracy report as a picture: error over CPU time, both on logarithmic scales; each point is labelled
// with its time step.
#include "accuracy/accuracy.h"
#include "render/image.h"

namespace morula {

/// One line per series; what failed, parted or is not resolved is not drawn.
Image drawAccuracy(const AccuracyReport& report);

}  // namespace morula
