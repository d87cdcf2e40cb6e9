// How runs differ from what is accepted, and from one another.
#include <algorithm>
#include <map>

#include "report/check_tables.h"
#include "report/run_blocks.h"

namespace morula {
namespace {

constexpr std::size_t mostChanges = 4;  // runs that are held against the first one of their scenario

void tellBesideGolden(const RunFacts& run, Document& changes) {
  if (run.change.empty()) {
    changes.say("Nothing: the run gives what the accepted result, " + code(run.golden) + ", records.");
    return;
  }
  const auto goldens = [](const CheckResult& c) { return c.kind == "golden"; };
  const bool within =
      std::any_of(run.checks.begin(), run.checks.end(), goldens) &&
      std::all_of(run.checks.begin(), run.checks.end(), [&](const CheckResult& c) { return !goldens(c) || c.passed; });
  changes.say((within ? "Nothing beyond the tolerances of the accepted result, " : "Beside the accepted result, ") +
              code(run.golden) + ":");
  changes.add(changeTable(run.change, run.scenario.names));
}

void tellBesideFirst(const RunFacts& first, const RunFacts& run, Document& changes) {
  const std::string change = changeBetween(first, run);
  changes.say("Beside " + titleOf(first) +
              (change.empty()         ? ": nothing."
               : change == run.change ? ": the same."
                                      : ":"));
  if (!change.empty() && change != run.change) changes.add(changeTable(change, run.scenario.names));
}

}  // namespace

Document changesOf(const std::vector<RunFacts>& runs) {
  Document all;
  std::map<std::string, const RunFacts*> firsts;  // of each scenario
  std::size_t told = 0;
  for (const RunFacts& run : runs) {
    if (run.run.status != RunStatus::done || !run.label.empty()) continue;
    Document changes;
    if (!run.golden.empty() && run.unusableGolden.empty() && (runs.size() == 1 || !run.change.empty()))
      tellBesideGolden(run, changes);
    const auto [first, isFirst] = firsts.emplace(run.run.record.scenario, &run);
    if (!isFirst && ++told <= mostChanges) tellBesideFirst(*first->second, run, changes);
    if (changes.empty()) continue;
    if (runs.size() > 1) all.heading(titleOf(run));
    all.add(std::move(changes));
  }
  if (told > mostChanges)
    all.note("Of the runs of one scenario the first " + std::to_string(mostChanges + 1) + " are told of.");
  return all;
}

}  // namespace morula
