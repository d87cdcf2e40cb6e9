#pragma once
#include "base/error.h"

namespace morula {

/// A body that something has driven to where it cannot go on. What that was a rerun can measure
/// (runner/diagnose): the remedy here is only what to look at first.
struct BodyFailure : NumericalError {
  using NumericalError::NumericalError;
  double timeStep = 0;  // [time] one that should do, if the failure tells; else 0
};

}  // namespace morula
