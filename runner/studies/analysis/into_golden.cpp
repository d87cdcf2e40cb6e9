#include "analysis/into_golden.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "database/database.h"
#include "database/store_error.h"
#include "files/read_file.h"
#include "golden/accept.h"
#include "scenario/scenario.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// A golden states statistics in three digits: they are measured, not results.
double threeDigits(double a) { return std::stod(fmt::format("{:.2e}", a)); }

/// The texts of the scenarios that the study's plan varies.
std::vector<std::string> plannedScenarios(const std::filesystem::path& study) {
  Database db(study, Database::Mode::existing, std::chrono::seconds(5));
  Statement rows(db, "SELECT plan FROM study");
  std::vector<std::string> texts;
  if (!rows.start().next()) return texts;
  try {
    const Json plan = parseJson(rows.text(0));
    for (const Json& condition : plan.at("conditions")) {
      const auto number = condition.at("scenario").get<std::size_t>();
      texts.push_back(plan.at("files").at(number).at("text").get<std::string>());
    }
  } catch (const Json::exception&) {
    throw StoreError(study.string() +
                     ": its plan cannot be read; the file is damaged: make it again with morula study merge");
  }
  return texts;
}

std::vector<GoldenStatistic> statisticsOf(const StudyComparison& c, std::size_t axis) {
  std::vector<GoldenStatistic> statistics;
  for (const PairComparison& p : c.pairs) {
    const bool isFixed = std::ranges::any_of(p.at, [](const auto& level) { return level.has_value(); });
    if (p.axis != axis || p.a != 0 || isFixed || p.known != Known::estimated) continue;
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
  for (const std::string& text : plannedScenarios(study))
    if (text != own.bytes)
      throw InputError(scenario.string() + ": " + study.string() +
                       " is a study of another scenario, or of this one before it was changed; run the study again");
  const auto file = goldenPath(scenario);
  refuseWithinCi(file);
  Golden golden = readGoldenFile(file);
  if (golden.data.scenarioHash != own.meaning.text())
    throw InputError(file.string() + ": the scenario has changed since; accept its result first");
  golden.statistics = statisticsOf(comparison, comparison.by.front());
  if (golden.statistics.empty())
    throw InputError(study.string() + ": has no difference to state: it needs two runs of each of two levels at least");
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

}  // namespace morula
