// How runs differ from what is accepted, and from one another.
#include <algorithm>
#include <map>

#include "report/check_tables.h"
#include "report/run_blocks.h"

namespace morula {

namespace {

constexpr std::size_t mostChanges = 4;  // runs that are held against the first one of their scenario

std::string besideGolden(const RunFacts& run) {
  const std::string golden = "<code>" + shown(run.golden) + "</code>";
  if (run.change.empty())
    return "<p>Nothing: the run gives what the accepted result, " + golden + ", records.</p>\n";
  const auto goldens = [](const CheckResult& c) { return c.kind == "golden"; };
  const bool within = std::any_of(run.checks.begin(), run.checks.end(), goldens) &&
                      std::all_of(run.checks.begin(), run.checks.end(),
                                  [&](const CheckResult& c) { return !goldens(c) || c.passed; });
  return (within ? "<p>Nothing beyond the tolerances of the accepted result, "
                 : "<p>Beside the accepted result, ") +
         golden + ":</p>\n" + changeTable(run.change, run.scenario.names);
}

std::string besideFirst(const RunFacts& first, const RunFacts& run) {
  const std::string change = changeBetween(first, run), beside = "<p>Beside " + shown(titleOf(first));
  if (change.empty()) return beside + ": nothing.</p>\n";
  return change == run.change ? beside + ": the same.</p>\n"
                              : beside + ":</p>\n" + changeTable(change, run.scenario.names);
}

}  // namespace

std::string changesOf(const std::vector<RunFacts>& runs) {
  std::string html;
  std::map<std::string, const RunFacts*> firsts;  // of each scenario
  std::size_t told = 0;
  for (const RunFacts& run : runs) {
    if (run.run.status != RunStatus::done || !run.label.empty()) continue;
    std::string changes;
    if (!run.golden.empty() && run.unusableGolden.empty() && (runs.size() == 1 || !run.change.empty()))
      changes = besideGolden(run);
    const auto [first, isFirst] = firsts.emplace(run.run.record.scenario, &run);
    if (!isFirst && ++told <= mostChanges) changes += besideFirst(*first->second, run);
    if (!changes.empty()) html += (runs.size() > 1 ? "<h3>" + shown(titleOf(run)) + "</h3>\n" : "") + changes;
  }
  if (told > mostChanges)
    html += "<p class=\"note\">Of the runs of one scenario the first " + std::to_string(mostChanges + 1) +
            " are told of.</p>\n";
  return html;
}

}  // namespace morula
