#pragma once
#include "base/error.h"

namespace morula {

/// A body that cannot be computed any further. The cause can be measured by a rerun (runner/runs/diagnose): the remedy
/// in this failure only says what to look at first.
struct BodyFailure : NumericalError {
  using NumericalError::NumericalError;
  double timeStep = 0;  // [time] a step that should do, if the failure tells; else 0
};

}  // namespace morula
