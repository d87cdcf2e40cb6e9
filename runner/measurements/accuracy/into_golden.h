#pragma once
// accuracy --into-golden: the error of a scenario as it lies there goes into its golden file.
#include "accuracy/accuracy.h"

namespace morula {

/// Throws InputError where there is no golden of this very scenario, or none may be written.
void refuseIntoGolden(const Scenario& scenario);

/// Throws InputError for a report without an error, FileError if the file cannot be written.
void writeIntoGolden(const Scenario& scenario, const AccuracyReport& report);

}  // namespace morula
