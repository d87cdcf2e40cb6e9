// compare --into-golden: writes the effects of a scenario's settings on its end into its golden file.

#include "accuracy/into_golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/study_comparison.h"
#include "base/error.h"
#include "golden/accept.h"
#include "scenario/scenario.h"
#include "store/build_info.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// Rounds to three digits, as goldens state statistics: they are measured, not results.
double threeDigits(double a) { return std::stod(fmt::format("{:.2e}", a)); }

std::vector<GoldenStatistic> statisticsOf(const StudyComparison& c, std::size_t axis) {
  std::vector<GoldenStatistic> statistics;
  for (const PairComparison& p : c.pairs) {
    if (p.axis != axis || p.a != 0 || !p.isOfMean()) continue;
    if (p.known != Known::estimated && p.known != Known::onePath) continue;
    const bool onePath = p.known == Known::onePath;
    const double same = p.paired.difference;  // under every seed, or on one path, if there is no interval
    const Interval range = onePath ? Interval{same, same} : p.paired.interval.value_or(Interval{same, same});
    statistics.push_back({c.measureName(p.measure), c.results.axes[axis].labels[p.b], threeDigits(same),
                          threeDigits(range.low), threeDigits(range.high), p.of.size(), onePath});
  }
  return statistics;
}

/// Returns the results of one base, without the axis `base`. If several bases hold the scenario, the first counts.
StudyResults ofBase(StudyResults results, const std::vector<bool>& isOfScenario) {
  const auto axis = std::ranges::find(results.axes, "base", &ResultAxis::name);
  const bool hasBases = axis != results.axes.end();
  const auto number = axis - results.axes.begin();
  std::vector<ResultCondition> kept;
  for (std::size_t i = 0; i < results.conditions.size(); ++i) {
    ResultCondition& c = results.conditions[i];
    if (!isOfScenario[i] || (hasBases && !kept.empty() && c.levels[number] != kept.front().levels[number])) continue;
    kept.push_back(std::move(c));
  }
  results.conditions = std::move(kept);
  if (!hasBases) return results;
  for (ResultCondition& c : results.conditions) c.levels.erase(c.levels.begin() + number);
  results.axes.erase(axis);
  return results;
}

/// Returns the scenario's present file with the role and name of a file of the condition, but with another content; ""
/// if there is none.
std::string changedFile(const Json& plan, const Json& condition, const Scenario& now) {
  for (const Json& number : condition.at("files")) {
    const Json& then = plan.at("files").at(number.get<std::size_t>());
    const std::string name = std::filesystem::path(then.at("path").get<std::string>()).filename().string();
    for (const NamedFile& file : now.files)
      if (file.role == then.at("role").get<std::string>() && std::filesystem::path(file.path).filename() == name &&
          file.content != then.at("text").get<std::string>())
        return file.path;
  }
  return {};
}

/// Throws InputError unless this program has computed the results: a golden's values are of one program.
void refuseOtherBuild(const StudyResults& results, const std::filesystem::path& study) {
  const std::string ours = buildId(buildInfo());
  if (!results.buildId.empty() && results.buildId != ours)
    throw InputError(study.string() + ": the study's runs were computed by another build of the program (" +
                     results.buildId + ", this is " + ours + "); run the study again, into a new folder");
}

/// Returns the scenario's golden, with the statistics of its runs alone.
Golden stated(const StudyResults& results, const CompareOptions& options, const std::filesystem::path& study,
              const std::filesystem::path& scenario) {
  refuseOtherBuild(results, study);
  const Scenario own = loadScenario(scenario);
  std::vector<bool> isOfScenario;  // [condition]
  std::string changed;             // a file that the scenario names and that has changed
  readStoredPlan(study, [&](const Json& plan) {
    for (const Json& condition : plan.at("conditions")) {
      isOfScenario.push_back(plan.at("files").at(condition.at("scenario").get<std::size_t>()).at("text") == own.bytes);
      if (isOfScenario.back() && changed.empty()) changed = changedFile(plan, condition, own);
    }
  });
  if (std::ranges::find(isOfScenario, true) == isOfScenario.end())
    throw InputError(scenario.string() + ": " + study.string() +
                     " is a study of another scenario, or of an older version of this scenario; run the study again");
  if (!changed.empty())
    throw InputError(scenario.string() + ": " + study.string() + " is a study of the scenario before " + changed +
                     " was changed; run the study again");
  const StudyComparison comparison = compareStudy(ofBase(results, isOfScenario), options);
  if (comparison.by.size() != 1)
    throw UsageError(
        "--into-golden compares the levels of one axis; name the axis "
        "with --by");
  refuseIntoGolden(own);
  Golden golden = readGoldenFile(goldenPath(scenario));
  golden.statistics = statisticsOf(comparison, comparison.by.front());
  if (golden.statistics.empty())
    throw InputError(study.string() + ": has no difference to state; needs at least two runs of each of two levels");
  return golden;
}

}  // namespace

void writeIntoGoldens(const StudyResults& results, CompareOptions options, const std::filesystem::path& study,
                      const std::vector<std::string>& scenarios) {
  // A golden is of one base, so the axis `base` has no levels to compare.
  if (std::erase(options.by, "base") > 0 && options.by.empty())
    throw UsageError(
        "--into-golden compares settings of each base separately; name the axis of the settings with "
        "--by");
  std::vector<Golden> goldens;  // all are made before the first is written
  for (const std::string& scenario : scenarios) goldens.push_back(stated(results, options, study, scenario));
  for (std::size_t i = 0; i < goldens.size(); ++i)
    acceptGolden(goldenPath(scenarios[i]), goldens[i], {goldens[i].acceptedBy, goldens[i].why});
}

}  // namespace morula
