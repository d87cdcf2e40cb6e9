#pragma once
// review --into-golden: writes the error of a scenario's own settings into its golden file, and shows the errors that
// golden files state.
#include "accuracy/accuracy.h"
#include "document/document.h"
#include "golden/golden.h"

namespace morula {

/// Throws InputError if the scenario has no golden of its present meaning, or goldens may not be written.
void refuseIntoGolden(const Scenario& scenario);

/// Measures the error of the scenario's own settings alone, up to the latest possible time, unless `options` gives a
/// time. Writes it, or the reason for its absence, into the golden. Throws InputError for a scene without a report,
/// after writing the reason, and FileError if the file cannot be written.
AccuracyReport stateInGolden(const ReadScenario& read, AccuracyOptions options);

/// Returns true if the golden's scene has bodies; goldens of other scenes are exact.
bool hasBodies(const Golden& golden);
/// Lists the errors that a golden states, one row per quantity; empty if it states none.
Document statedErrors(const Golden& golden);
/// Writes the stated errors of many goldens, one row each, sorted by name: golden/ERRORS.md.
std::string statedErrorsAsMarkdown(std::vector<Golden> goldens);

}  // namespace morula
