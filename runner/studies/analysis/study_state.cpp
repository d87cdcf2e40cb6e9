#include "analysis/study_state.h"

#include <fmt/format.h>

#include "files/text.h"
#include "study/plan.h"

namespace morula {
namespace {

constexpr std::size_t maxTold = 20;  // max lines for one state

std::vector<std::string>& toldOf(StudyState& s, ResultState state) { return s.told[static_cast<std::size_t>(state)]; }

std::vector<std::string> firstFew(std::vector<std::string> lines) {
  if (const std::size_t all = lines.size(); all > maxTold) {
    lines.resize(maxTold);
    lines.push_back(fmt::format("… and {} more", all - maxTold));
  }
  return lines;
}

}  // namespace

StudyState stateOf(const StudyResults& results, const AllowedRuns& allowed, const PlanDifference& difference) {
  StudyState state{.counts = results.counts(), .allowed = allowed, .told = {}};
  for (const auto& [condition, seed, task] : troubledRuns(results))
    toldOf(state, task.state())
        .push_back(fmt::format("{}, seed {}{}", condition, seed, task.reason.empty() ? "" : ": " + task.reason));
  state.counts.add(ResultState::missing, difference.missing);
  for (const std::string& line : difference.lacking) toldOf(state, ResultState::missing).push_back(line);
  state.counts.add(ResultState::stale, difference.stale.empty() ? 0 : 1);
  toldOf(state, ResultState::stale) = difference.stale;
  return state;
}

PlanDifference differenceFrom(const std::filesystem::path& database, const Study& now) {
  PlanDifference difference;
  const Plan plan = makePlan(now, {.predict = false});
  readStoredPlan(database, [&](const Json& stored) { difference = differenceFrom(stored, plan); });
  return difference;
}

std::string countsInWords(const StudyState& s) {
  if (s.counts.worst() == ResultState::fine) return "";
  return fmt::format("runs: {}; limits allow {} failed and {} insane", s.counts.text(), s.allowed.failed,
                     s.allowed.insane);
}

std::string linesOf(const StudyState& s) {
  std::string text;
  for (const ResultState state : valuesOf<ResultState>())
    for (const std::string& line : firstFew(s.told[static_cast<std::size_t>(state)]))
      text += fmt::format("  {:<9} {}\n", nameOf(state), line);
  return text;
}

Json toJson(const StudyState& s) {
  return {{"state", nameOf(s.worst())},
          {"states", s.counts.json()},
          {"allowed", {{"failed", s.allowed.failed}, {"insane", s.allowed.insane}}},
          {"stale", s.told[static_cast<std::size_t>(ResultState::stale)]}};
}

std::vector<CheckResult> checksOf(const StudyState& s, const std::string& file) {
  std::array<std::string, choices<ResultState>.size()> why;
  for (std::size_t i = 0; i < why.size(); ++i) why[i] = file + ": " + join(firstFew(s.told[i]), "\n");
  return checksOf(s.counts, s.allowed, why);
}

}  // namespace morula
