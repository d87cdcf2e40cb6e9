#pragma once
// accuracy --into-golden: the error of a scenario as it lies there goes into its golden file.
#include "accuracy/accuracy.h"
#include "golden/golden.h"
#include "scenario/scenario.h"

namespace morula {

/// Throws InputError where there is no golden of this very scenario, or none may be written.
void refuseIntoGolden(const Scenario& scenario);

/// Why the report has no error to state; "" if it has one.
std::string whyNoError(const AccuracyReport& report);

/// What a golden says of it, in two digits: it is measured, not a result.
GoldenError errorForGolden(const AccuracyReport& report);

/// Throws InputError for a report without an error, FileError if the file cannot be written.
void writeIntoGolden(const Scenario& scenario, const AccuracyReport& report);

}  // namespace morula
