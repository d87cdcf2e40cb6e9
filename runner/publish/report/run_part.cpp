// The part of a page on runs, from the verdict to the downloads.
#include <algorithm>
#include <map>
#include <set>

#include "accuracy/into_golden.h"
#include "base/number_text.h"
#include "check/against.h"
#include "check/remarks.h"
#include "files/printable.h"
#include "report/bullet_block.h"
#include "report/page_parts.h"
#include "report/run_blocks.h"
#include "report_data/run_words.h"
#include "store/records.h"
#include "system/installation.h"

namespace morula {
namespace {

using Kind = Finding::Kind;

bool passed(const CheckResult& r) { return r.passed; }

/// Returns the names of failed checks, each once.
std::string namesOf(const std::vector<CheckResult>& failed) {
  std::string names;
  std::set<std::string> said;
  for (const CheckResult& r : failed) {
    if (!said.insert(r.check).second) continue;
    if (said.size() > 6) return names + ", …";
    names += (names.empty() ? "" : ", ") + r.check;
  }
  return names;
}

void judgeChecks(const RunFacts& facts, std::vector<Finding>& findings) {
  std::vector<CheckResult> sanity, others;
  for (const CheckResult& r : facts.checks) (r.kind == CheckKind::sanity ? sanity : others).push_back(r);
  std::vector<CheckResult> insane, failed;
  std::remove_copy_if(sanity.begin(), sanity.end(), std::back_inserter(insane), passed);
  std::remove_copy_if(others.begin(), others.end(), std::back_inserter(failed), passed);
  if (!failed.empty())
    findings.push_back({Kind::bad, std::to_string(failed.size()) + " of " + counted(others.size(), "check") +
                                       (failed.size() == 1 ? " differs: " : " differ: ") + namesOf(failed)});
  else if (!others.empty())
    findings.push_back(
        {Kind::good, others.size() == 1 ? "The check passes" : "All " + counted(others.size(), "check") + " pass"});
  else if (facts.run.status == RunStatus::done)
    findings.push_back(
        {Kind::note, "Not compared with an accepted result: the database holds no such check of this run"});
  for (const CheckResult& r : insane) {
    std::string message = withNames(r.message.empty() ? r.check : r.message, facts.scenario.names.function());
    if (const std::string known = "not sane at the end: "; message.starts_with(known)) message.erase(0, known.size());
    findings.push_back(failedBecause(Kind::bad, "Not sane: ", message));
  }
  if (insane.empty() && !sanity.empty()) {
    if (facts.scenario.check.sane)
      findings.push_back({Kind::good, "Sane: no cell is crushed, torn or turned inside out"});
    else findings.push_back({Kind::good, "Need not be sane: " + facts.scenario.check.because});
  }
}

void judgeDivisions(const RunFacts& facts, std::vector<Finding>& findings) {
  if (facts.ambiguous.empty()) return;
  const DivisionRecord& first = facts.ambiguous.front();
  const std::size_t count = facts.ambiguous.size();
  const std::string cell = facts.scenario.names.of(first.path).value_or(cellName(first.path.text()));
  findings.push_back(
      {Kind::warning,
       counted(count, "division") + (count == 1 ? " has an" : " have an") +
           " ambiguous axis: the mother's longest extent is hardly longer than her next one, " +
           (count == 1 ? "" : "first ") + "that of " + cell + " at time " +
           shownTime(facts.scenario.units, first.time) + ", " +
           (*first.extentRatio - 1 < 1e-6 ? "longer by less than a millionth"
                                          : "longer by " + numberText(100 * (*first.extentRatio - 1), 2) + " %") +
           ". Another mesh, time step or precision may cut elsewhere"});
}

void judgeAgain(const RunFacts& facts, std::vector<Finding>& findings) {
  if (!facts.again || facts.again->same) return;
  const bool sameBuild = buildId(facts.run.record.build) == buildId(buildInfo());
  findings.push_back({sameBuild ? Kind::bad : Kind::warning,
                      std::string("The run, repeated for this page, ends in another state than is stored") +
                          (sameBuild ? ", though by the same program"
                                     : ", by another program: pictures and explorer show what this program "
                                       "computes, the tables what is stored")});
}

std::string statusText(const StoredRun& run, const Units& units) {
  const std::string cells = counted(run.cells, "cell"),
                    when = " at time " + shownTime(units, run.time, 6) + " after " + counted(run.steps, "step");
  switch (run.status) {
    case RunStatus::done: return "is done: " + cells + when;
    case RunStatus::failed: return "failed" + when + ", with " + cells;
    case RunStatus::killed: return "was interrupted" + when + ", with " + cells;
    case RunStatus::running: break;
  }
  return "has not ended";
}

std::string sentenceOf(const std::vector<const RunFacts*>& runs, bool bad, bool warned) {
  const std::string ending = bad ? ". There are faults." : warned ? ". There are warnings." : ". There are no faults.";
  if (runs.size() == 1) return "The run " + statusText(runs[0]->run, runs[0]->scenario.units) + ending;
  const auto done =
      std::count_if(runs.begin(), runs.end(), [](const RunFacts* r) { return r->run.status == RunStatus::done; });
  return std::to_string(done) + " of " + counted(runs.size(), "run") + (done == 1 ? " is" : " are") + " done" + ending;
}

/// Adds a finding on runs of one scenario with different seeds and the same end.
void judgeSeeds(const std::vector<const RunFacts*>& runs, std::vector<Finding>& findings) {
  const auto keyOf = [](const RunFacts& r) { return r.run.record.scenario + ' ' + r.run.stateHash; };
  std::map<std::string, std::set<std::uint64_t>> seeds;
  for (const RunFacts* r : runs)
    if (r->run.status == RunStatus::done) seeds[keyOf(*r)].insert(r->run.record.seed);
  for (const RunFacts* run : runs) {
    const RunFacts& r = *run;
    const auto same = seeds.find(keyOf(r));
    if (same == seeds.end() || same->second.size() < 2) continue;
    findings.push_back(
        {Kind::warning,
         counted(same->second.size(), "seed") + " of " + r.run.record.scenario +
             " gave the same result, bit for bit, so they are no replicates" +
             (usesSeed(r.scenario.scene) ? "" : ", because nothing in this scenario varies with the seed")});
    seeds.erase(same);  // told once
  }
}

Table runTable(const std::vector<const RunFacts*>& runs) {
  Table table{"Runs", {"Run", "Status", "Cells", "Time", "Checks", "End state", "Id"}};
  for (const RunFacts* run : runs) {
    const RunFacts& r = *run;
    const auto failed = std::count_if(r.checks.begin(), r.checks.end(), [](const CheckResult& c) { return !c.passed; });
    table.rows.push_back({titleOf(r), name(r.run.status), r.run.cells,
                          Cell(r.run.time, shownTime(r.scenario.units, r.run.time, 6)),
                          r.checks.empty() ? "none"
                          : failed ? std::to_string(failed) + " of " + std::to_string(r.checks.size()) + " failed"
                                   : "all " + std::to_string(std::ranges::count_if(r.checks, wasCompared)) + " passed",
                          code(r.run.stateHash.substr(0, 12)), code(r.run.id)});
  }
  return table;
}

/// Returns the findings that a reader must know first: failures, states that are not sane, ambiguities.
std::vector<Finding> findingsOf(const RunFacts& facts) {
  std::vector<Finding> findings;
  const StoredRun& run = facts.run;
  if (run.status == RunStatus::failed)
    findings.push_back(facts.scenario.check.fails.empty()
                           ? failedBecause(Kind::bad, "The run failed: ", run.failure)
                           : failedBecause(Kind::good, "The run failed, as it has to: ", run.failure));
  if (run.status == RunStatus::killed)
    findings.push_back({Kind::warning, "The run was interrupted; morula run --resume continues it"});
  if (run.status == RunStatus::running)
    findings.push_back({Kind::warning, "The run has not ended, or its program was killed: there are no results yet"});
  judgeChecks(facts, findings);
  judgeDivisions(facts, findings);
  if (const auto& mechanics = facts.scenario.scene.mechanics) {
    const auto& settlings = facts.results.settlings;
    if (const std::string unsettled = unsettledText(mechanics->physics, settlings); !unsettled.empty())
      findings.push_back({Kind::warning, unsettled});
    if (const std::string settled = settledText(mechanics->physics, settlings); !settled.empty())
      findings.push_back({Kind::note, "Settled: " + settled});
    if (const std::string distance = distanceText(settlings); !distance.empty())
      findings.push_back({Kind::note, distance});
  }
  for (const std::string& remark : againstRemarks(facts.results.against, facts.scenario.units))
    findings.push_back({Kind::warning, remark});
  for (const std::string& line : experimentLines(facts.scenario, facts.results.experiments))
    findings.push_back({Kind::note, "Experiment: " + line});
  judgeAgain(facts, findings);
  judgeBullet(facts, findings);
  if (!facts.unusableGolden.empty())
    findings.push_back({Kind::warning, "The golden file cannot be used: " + facts.unusableGolden});
  for (const std::string& warning : facts.scenario.warnings) findings.push_back({Kind::warning, warning});
  return findings;
}

/// Gathers the findings of all runs, but good ones; a finding on several runs is told once.
void gather(const std::vector<const RunFacts*>& runs, std::vector<Finding>& findings) {
  std::vector<std::pair<Finding, std::vector<Words>>> found;  // each finding with the titles of its runs
  for (const RunFacts* run : runs)
    for (Finding& f : findingsOf(*run)) {
      if (f.kind == Kind::good || f.kind == Kind::note) continue;
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& known) { return known.first == f; });
      const Words title = bold(titleOf(*run));
      if (same == found.end()) found.push_back({std::move(f), {title}});
      else same->second.push_back(title);
    }
  for (auto& [finding, titles] : found) {
    finding.words = (titles.size() < runs.size() ? listed(titles, 3)
                     : runs.size() == 2          ? "Both runs"
                                                 : "All runs") +
                    ": " + finding.words;
    findings.push_back(std::move(finding));
  }
}

/// Returns the verdict: one sentence and the findings; for several runs also a table of them.
Document verdictOf(const std::vector<const RunFacts*>& runs) {
  std::vector<Finding> findings;
  judgeSeeds(runs, findings);
  if (runs.size() == 1) findings = findingsOf(*runs[0]);
  else gather(runs, findings);
  const auto has = [&](Kind kind) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
  };
  Words sentence = sentenceOf(runs, has(Kind::bad), has(Kind::warning));
  Document all = verdict(std::move(sentence), std::move(findings));
  if (runs.size() > 1) all.add(runTable(runs));
  return all;
}

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
    else if (runs.size() <= maxExplored)
      all.add(folded(titleOf(run) + ": all " + counted(run.checks.size(), "check") + " passed", std::move(checks)));
  }
  return all;
}

/// Returns the comparisons of runs with measured cells.
Document againstOfAll(const std::vector<RunFacts>& runs) {
  Document all;
  for (const RunFacts& run : runs) {
    if (run.results.against.empty()) continue;
    if (runs.size() > 1) all.heading(titleOf(run));
    all.add(againstTable(run.results.against, run.scenario));
  }
  if (!all.empty())
    all.note(
        "Root mean square distances of the cells' centres from measured places, to which the organism is turned and "
        "moved, never mirrored.");
  return all;
}

/// Returns the errors that the scenarios' goldens state, each once.
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

PagePart runPart(const std::vector<RunFacts>& runs, std::size_t maxBytes) {
  // A study's findings are about all of its runs, so runs that represent its conditions are not judged.
  std::vector<const RunFacts*> judged;
  for (const RunFacts& run : runs)
    if (run.label.empty()) judged.push_back(&run);
  PagePart part{.title = titleOfRuns(runs, judged.size()),
                .summary = areOfOneScenario(runs) ? printable(runs[0].scenario.summary) : "",
                .isAside = judged.empty()};
  if (!judged.empty()) part.verdict = verdictOf(judged);
  if (Document changes = changesOf(runs); !changes.empty())
    part.change.push_back({"change", "What changed", std::move(changes)});
  if (PageSection bullet = bulletSection(runs); !bullet.body.empty()) part.sections.push_back(std::move(bullet));
  part.sections.push_back(pictureSection(runs));
  part.sections.push_back(chartSection(runs, part.charts));
  if (Document against = againstOfAll(runs); !against.empty())
    part.sections.push_back({"against", "Measured places", std::move(against)});
  if (Document checks = checksOfAll(runs); !checks.empty()) {
    part.sections.push_back({"checks", "Checks", std::move(checks)});
    const auto ofGolden = [](const CheckResult& c) { return c.kind == CheckKind::golden; };
    if (runs.size() == 1 && !runs[0].golden.empty() &&
        std::any_of(runs[0].checks.begin(), runs[0].checks.end(), ofGolden))
      part.sections.back().commands = {programWord() + " check " + shellWord(sourceOf(runs[0])),
                                       programWord() + " explain " + shellWord(sourceOf(runs[0]))};
  }
  if (Document errors = errorsOf(runs); !errors.empty())
    part.sections.push_back({"errors", "Errors of the result", std::move(errors)});
  part.sections.push_back(provenanceSection(runs));
  part.sections.push_back(parameterSection(runs));
  part.sections.push_back(downloadSection(runs, maxBytes / 10));
  return part;
}

}  // namespace morula
