// compare --into-golden: what a scenario's settings change at its end goes into its golden file.

#include "accuracy/into_golden.h"

#include <fmt/format.h>

#include "analysis/comparison.h"
#include "base/error.h"
#include "golden/accept.h"
#include "scenario/scenario.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// A golden states statistics in three digits: they are measured, not results.
double threeDigits(double a) { return std::stod(fmt::format("{:.2e}", a)); }

std::vector<GoldenStatistic> statisticsOf(const StudyComparison& c, std::size_t axis) {
  std::vector<GoldenStatistic> statistics;
  for (const PairComparison& p : c.pairs) {
    if (p.axis != axis || p.a != 0 || !p.isOfMean() || p.known != Known::estimated) continue;
    const double same = p.paired.difference;  // under every seed, where there is no interval
    const Interval range = p.paired.interval.value_or(Interval{same, same});
    statistics.push_back({c.measureName(p.measure), c.results.axes[axis].labels[p.b], threeDigits(same),
                          threeDigits(range.low), threeDigits(range.high), p.of.size()});
  }
  return statistics;
}

}  // namespace

void writeIntoGolden(const StudyComparison& comparison, const std::filesystem::path& study,
                     const std::filesystem::path& scenario) {
  if (comparison.by.size() != 1) throw UsageError("--into-golden: compares the levels of one axis; name it with --by");
  const Scenario own = loadScenario(scenario);
  readStoredPlan(study, [&](const Json& plan) {
    for (const Json& condition : plan.at("conditions"))
      if (plan.at("files").at(condition.at("scenario").get<std::size_t>()).at("text") != own.bytes)
        throw InputError(scenario.string() + ": " + study.string() +
                         " is a study of another scenario, or of this one before it was changed; run the study again");
  });
  refuseIntoGolden(own);
  const auto file = goldenPath(scenario);
  Golden golden = readGoldenFile(file);
  golden.statistics = statisticsOf(comparison, comparison.by.front());
  if (golden.statistics.empty())
    throw InputError(study.string() + ": has no difference to state: it needs two runs of each of two levels at least");
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

}  // namespace morula
