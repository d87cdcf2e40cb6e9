#pragma once
#include "accuracy/accuracy.h"

namespace morula {

/// The report for people.
std::string describe(const AccuracyReport& report);

}  // namespace morula
