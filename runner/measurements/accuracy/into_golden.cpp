#include "accuracy/into_golden.h"

#include <fmt/format.h>

#include "base/error.h"
#include "golden/accept.h"

namespace morula {

namespace {

/// A golden states an error in two digits: it is measured, not a result.
double twoDigits(double a) { return std::stod(fmt::format("{:.1e}", a)); }

/// "" if it has one.
std::string whyNoError(const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  if (!own.failure.empty()) return own.failure;
  if (!own.error || own.partedAt) return "its lineage is not the reference's";
  if (report.reference.left.error > *own.error)
    return fmt::format("the reference's own is {:.2g} and the scenario's {:.2g}; compare a shorter time (--until)",
                       report.reference.left.error, *own.error);
  return "";
}

}  // namespace

void refuseIntoGolden(const Scenario& scenario) {
  const auto file = goldenPath(scenario.file);
  refuseWithinCi(file);
  if (readGoldenFile(file).data.scenarioHash != scenario.meaning.text())
    throw InputError(file.string() + ": the scenario has changed since; accept its result first");
}

void writeIntoGolden(const Scenario& scenario, const AccuracyReport& report) {
  if (const std::string why = whyNoError(report); !why.empty())
    throw InputError(scenario.file + ": it has no error to state: " + why);
  const auto file = goldenPath(scenario.file);
  Golden golden = readGoldenFile(file);
  // A mesh's error over a shorter time is another statement: the line has one `until`.
  const bool asLong = report.mesh.none || report.mesh.until >= report.times.back();
  const auto mesh = asLong ? report.mesh.error() : std::nullopt;
  golden.error = {twoDigits(*report.own.error), mesh ? std::optional(twoDigits(*mesh)) : std::nullopt,
                  report.times.back()};
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

}  // namespace morula
