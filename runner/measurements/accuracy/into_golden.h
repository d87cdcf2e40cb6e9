#pragma once
// accuracy --into-golden: the error of a scenario as it lies there goes into its golden file, and what golden files
// state.
#include "accuracy/accuracy.h"
#include "document/document.h"
#include "golden/golden.h"

namespace morula {

/// Throws InputError where there is no golden of this very scenario, or none may be written.
void refuseIntoGolden(const Scenario& scenario);

/// Measures up to the latest time up to which there is an error, unless `options` say it, and writes it into the
/// golden, or why there is none. Throws InputError for a scene without a report, which the golden tells, FileError if
/// the file cannot be written.
AccuracyReport stateInGolden(const ReadScenario& read, AccuracyOptions options);

/// Returns true if the golden's scene has bodies; goldens of other scenes are exact.
bool hasBodies(const Golden& golden);
/// Lists the errors that a golden states, one row per quantity; empty if it states none.
Document statedErrors(const Golden& golden);
/// Writes the stated errors of many goldens, one row each, sorted by name: golden/ERRORS.md.
std::string statedErrorsAsMarkdown(std::vector<Golden> goldens);

}  // namespace morula
