#pragma once
// review --into-golden: writes the error of a scenario's own settings into its golden file.
#include "accuracy/accuracy.h"

namespace morula {

/// Throws InputError if the scenario has no golden of its present meaning, or goldens may not be written.
void refuseIntoGolden(const Scenario& scenario);

/// Measures the error of the scenario's own settings alone, up to the latest possible time, unless `options` gives a
/// time. Writes it, or the reason for its absence, into the golden. Throws InputError for a scene without a report,
/// after writing the reason, and FileError if the file cannot be written.
AccuracyReport stateInGolden(const ReadScenario& read, AccuracyOptions options);

}  // namespace morula
