#pragma once
// The errors of a scenario's own settings, at rest and at worst: as goldens state them, and as people see them.
#include <cstddef>
#include <string>
#include <vector>

#include "accuracy/run_distance.h"
#include "document/document.h"
#include "golden/golden.h"

namespace morula {

struct AccuracyReport;

/// Stated errors at worst are the largest measured ones times this factor, since errors are larger between the times of
/// comparison, and against other meshes. With 1.5 dense tests are covered in 17 of 20 scenes, with 2 in all of them
/// (tests/unit/accuracy/dense_test.cpp).
inline constexpr double worstMargin = 2;

struct StatedErrors {
  std::vector<GoldenError> errors;       // one for each quantity; empty: none can be stated
  std::vector<GoldenUnstated> unstated;  // why there are no errors, or none beyond a time
  std::size_t times = 0;                 // number of times of comparison
  std::size_t quietTimes = 0;            // number of these without an event within 10 steps
  std::size_t events = 0;                // number of starts, births, deaths and first contacts
};

/// Returns the reason why a report has no error to state; "" if it has one.
std::string whyNoError(const AccuracyReport& report);
/// States the errors of the report's scenario. `own`: the distance of its own run from the reference, at all `times`
/// [time].
StatedErrors stateErrors(const AccuracyReport& report, const RunDistance& own, const std::vector<double>& times);

/// Returns a failure without the figures and advice at its end.
std::string shortly(const std::string& why);

/// Returns a table of errors, with a row for each quantity, and what its columns mean.
Document describeErrors(const std::vector<GoldenError>& errors);

/// Describes the errors of a report's scenario: the table, the number of times, and what is not stated.
Document describeStated(const StatedErrors& stated);

/// Returns true if the golden's scene has bodies; goldens of other scenes are exact.
bool hasBodies(const Golden& golden);
/// Lists the errors that a golden states; empty if it states none.
Document statedErrors(const Golden& golden);
/// Writes the stated errors of many goldens, one row each, sorted by name: golden/ERRORS.md.
std::string statedErrorsAsMarkdown(std::vector<Golden> goldens);

}  // namespace morula
