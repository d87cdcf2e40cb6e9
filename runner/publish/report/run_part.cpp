// Runs on a page, from the verdict to the downloads.
#include <algorithm>
#include <set>

#include "accuracy/into_golden.h"
#include "files/printable.h"
#include "report/bullet_block.h"
#include "report/check_tables.h"
#include "report/parts.h"
#include "report/run_blocks.h"
#include "report/verdict.h"
#include "system/installation.h"

namespace morula {
namespace {

bool areOfOneScenario(const std::vector<RunFacts>& runs) {
  return std::all_of(runs.begin(), runs.end(),
                     [&](const RunFacts& r) { return r.run.record.scenario == runs[0].run.record.scenario; });
}

std::string titleOfRuns(const std::vector<RunFacts>& runs, std::size_t own) {
  const std::size_t ofStudies = runs.size() - own;
  if (own == 0)
    return (ofStudies == 1 ? "a run that stands for " : "runs that stand for ") + counted(ofStudies, "condition");
  if (runs.size() == 1) return titleOf(runs[0]);
  return (areOfOneScenario(runs) ? runs[0].run.record.scenario + ", " : "") + counted(own, "run") +
         (ofStudies ? " and " + std::to_string(ofStudies) + " for conditions of studies" : "");
}

Document checksOfAll(const std::vector<RunFacts>& runs) {
  Document all;
  for (const RunFacts& run : runs) {
    if (run.checks.empty()) continue;
    const bool differs =
        std::any_of(run.checks.begin(), run.checks.end(), [](const CheckResult& c) { return !c.passed; });
    Document checks = checksOf(run.checks, run.scenario.names);
    if (runs.size() == 1) all.add(std::move(checks));
    else if (differs) all.heading(titleOf(run)).add(std::move(checks));
    else if (runs.size() <= mostExplored)
      all.add(folded(titleOf(run) + ": all " + counted(run.checks.size(), "check") + " passed", std::move(checks)));
  }
  return all;
}

/// What goldens state of the scenarios, each once.
Document errorsOf(const std::vector<RunFacts>& runs) {
  Document all;
  std::set<std::string> said;
  for (const RunFacts& run : runs) {
    if (run.golden.empty() || !run.unusableGolden.empty()) continue;
    const Golden golden = readGoldenFile(run.golden);
    if (golden.data.scenarioHash != run.run.record.scenarioHash || !said.insert(golden.data.scenario).second) continue;
    Document errors = statedErrors(golden);
    if (runs.size() > 1 && !errors.empty()) all.heading(golden.data.scenario);
    all.add(std::move(errors));
  }
  return all;
}

}  // namespace

PagePart runPart(const std::vector<RunFacts>& runs, std::size_t mostBytes) {
  // What is said of a study is said of all of its runs, not of those that stand for its conditions.
  std::vector<const RunFacts*> judged;
  for (const RunFacts& run : runs)
    if (run.label.empty()) judged.push_back(&run);
  PagePart part{.title = titleOfRuns(runs, judged.size()),
                .summary = areOfOneScenario(runs) ? printable(runs[0].scenario.summary) : "",
                .verdict = {},
                .isAside = judged.empty()};
  if (!judged.empty()) part.verdict = verdictOf(judged);
  if (Document changes = changesOf(runs); !changes.empty())
    part.change.push_back({"change", "What changed", std::move(changes)});
  if (PageSection bullet = bulletSection(runs); !bullet.body.empty()) part.sections.push_back(std::move(bullet));
  part.sections.push_back(pictureSection(runs));
  part.sections.push_back(chartSection(runs));
  if (Document checks = checksOfAll(runs); !checks.empty()) {
    part.sections.push_back({"checks", "Checks", std::move(checks)});
    const auto ofGolden = [](const CheckResult& c) { return c.kind == "golden"; };
    if (runs.size() == 1 && !runs[0].golden.empty() &&
        std::any_of(runs[0].checks.begin(), runs[0].checks.end(), ofGolden))
      part.sections.back().commands = {programWord() + " check " + shellWord(sourceOf(runs[0])),
                                       programWord() + " explain " + shellWord(sourceOf(runs[0]))};
  }
  if (Document errors = errorsOf(runs); !errors.empty())
    part.sections.push_back({"errors", "How exact it is", std::move(errors)});
  part.sections.push_back(provenanceSection(runs));
  part.sections.push_back(parameterSection(runs));
  part.sections.push_back(downloadSection(runs, mostBytes / 10));
  return part;
}

}  // namespace morula
