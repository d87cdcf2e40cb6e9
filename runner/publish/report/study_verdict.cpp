// What must be known first of a study: which runs failed or are not sane, which are no replicates, which cut an ambiguous axis.
#include <algorithm>
#include <set>

#include "check/ambiguous.h"
#include "database/database.h"
#include "division/record.h"
#include "loop/stored_scenario.h"
#include "report/study_part.h"
#include "store/store.h"

namespace morula {
namespace {

struct Trouble {
  std::string condition, status, reason;
  auto operator<=>(const Trouble&) const = default;
};

/// Runs that failed, are missing or are not sane: those of one condition with one reason once.
void judgeTasks(const StudyResults& r, std::vector<Finding>& findings) {
  std::vector<std::pair<Trouble, std::vector<std::string>>> found;  // with the seeds
  for (const auto& [condition, seed, task] : troubledRuns(r)) {
    const Trouble trouble{condition, task.status, task.reason};
    auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == trouble; });
    if (same == found.end()) same = found.insert(found.end(), {trouble, {}});
    same->second.push_back(std::to_string(seed));
  }
  for (const auto& [trouble, seeds] : found) {
    const Words which =
        bold(trouble.condition) + ", " + (seeds.size() == 1 ? "seed " : "seeds ") + listed(seeds, 12) + ": ";
    if (trouble.status == "done")
      findings.push_back({Finding::Kind::bad,
                          which + "not sane: bodies ended in a state that cannot be. The values count all the same"});
    else if (trouble.status == "missing")
      findings.push_back({Finding::Kind::warning, which + "missing; morula study run goes on with the study"});
    else {
      Finding failed = failedBecause(Finding::Kind::bad, trouble.reason.empty() ? "" : ": ", trouble.reason);
      failed.words = which + trouble.status + failed.words;
      findings.push_back(std::move(failed));
    }
  }
}

/// Conditions that are the same runs, and those whose seeds change nothing.
void judgeConditions(const StudyComparison& c, std::vector<Finding>& findings) {
  const StudyResults& r = c.results;
  for (const auto& names : namesOfSameRuns(r)) {
    std::vector<Words> bolds;
    for (const std::string& name : names) bolds.push_back(bold(name));
    findings.push_back({Finding::Kind::warning, listed(bolds, 12) + " are the same runs"});
  }
  for (const std::size_t k : c.seedless)
    findings.push_back(
        {Finding::Kind::warning, "Seeds change nothing under " + bold(r.nameOf(r.conditions[k])) +
                                     ": its runs are one run, no replicates, and its mean has no interval"});
}

/// Runs with divisions whose axis is ambiguous.
void judgeDivisions(const StudyResults& r, const std::string& database, std::vector<Finding>& findings) {
  std::set<std::string> suspects;
  {
    Database db(database, Database::Mode::existing, std::chrono::milliseconds(30'000));
    Statement find(db, "SELECT DISTINCT run_id FROM division WHERE extent_ratio < ?");
    find.start(ambiguousExtentRatio);
    while (find.next()) suspects.insert(find.line(0));
  }
  auto store = Store::openForReading(database);
  std::vector<Words> conditions;
  std::size_t runs = 0;
  std::set<std::string> seen;
  for (const ResultCondition& condition : r.conditions) {
    const std::size_t before = runs;
    for (const std::size_t t : condition.tasks) {
      if (t == noTask || !suspects.contains(r.tasks[t].runId) || !seen.insert(r.tasks[t].runId).second) continue;
      const StoredRun run = store.find(r.tasks[t].runId);
      const RunResults results = store.results(run.id);
      const Scenario scenario = storedScenario(database, run.id);
      runs += !ambiguousDivisions(
                   scenario.scene, results.lineage, [&](StateId state) { return results.stateTexts.at(state); },
                   results.divisions)
                   .empty();
    }
    if (runs > before) conditions.push_back(bold(r.nameOf(condition)));
  }
  if (runs)
    findings.push_back({Finding::Kind::warning,
                        counted(runs, "run") + (runs == 1 ? " has" : " have") +
                            " divisions with an ambiguous axis, under " + listed(conditions) +
                            ": the longest extent of a mother is hardly longer than her next one. With another mesh, "
                            "time step or precision such a cut may lie elsewhere"});
}

}  // namespace

std::vector<Finding> findingsOf(const StudyComparison& c, const std::string& database) {
  const StudyResults& r = c.results;
  std::vector<Finding> findings;
  judgeTasks(r, findings);
  judgeConditions(c, findings);
  judgeDivisions(r, database, findings);
  if (std::all_of(r.tasks.begin(), r.tasks.end(), [](const ResultTask& t) { return t.status == "done" && t.isSane; }))
    findings.push_back({Finding::Kind::good, "Every run is done, and sane"});
  return findings;
}

}  // namespace morula
