#pragma once
#include "base/error.h"

namespace morula {

/// A body that cannot be computed any further. The cause can be measured by a rerun (runner/runs/diagnose): the remedy
/// here is only what to look at first.
struct BodyFailure : NumericalError {
  using NumericalError::NumericalError;
  double timeStep = 0;  // [time] one that should do, if the failure tells; else 0
};

}  // namespace morula
