#include "report/verdict.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/number_text.h"
#include "page/page.h"
#include "report/bullet_block.h"
#include "store/records.h"

namespace morula {

namespace {

using Kind = Finding::Kind;

bool passed(const CheckResult& r) { return r.passed; }

std::string inPercent(double share) { return share == 0 ? "0 %" : numberText(100 * share, 3) + " %"; }

/// The names of those that failed, each once.
std::string namesOf(const std::vector<CheckResult>& failed) {
  std::string names;
  std::set<std::string> said;
  for (const CheckResult& r : failed) {
    if (!said.insert(r.check).second) continue;
    if (said.size() > 6) return names + ", …";
    names += (names.empty() ? "" : ", ") + shown(r.check);
  }
  return names;
}

void judgeChecks(const RunFacts& facts, std::vector<Finding>& findings) {
  std::vector<CheckResult> sanity, others;
  for (const CheckResult& r : facts.checks) (r.kind == "sanity" ? sanity : others).push_back(r);
  std::vector<CheckResult> insane, failed;
  std::remove_copy_if(sanity.begin(), sanity.end(), std::back_inserter(insane), passed);
  std::remove_copy_if(others.begin(), others.end(), std::back_inserter(failed), passed);
  if (!failed.empty())
    findings.push_back({Kind::bad, std::to_string(failed.size()) + " of " + counted(others.size(), "check") +
                                       (failed.size() == 1 ? " differs: " : " differ: ") + namesOf(failed)});
  else if (!others.empty())
    findings.push_back({Kind::good, others.size() == 1 ? "The check passes"
                                                       : "All " + counted(others.size(), "check") + " pass"});
  else if (facts.run.status == RunStatus::done)
    findings.push_back({Kind::good, "Not checked: the database holds no check of this run"});
  for (const CheckResult& r : insane)
    findings.push_back({Kind::bad, "Not sane: " + shown(withNames(r.message.empty() ? r.check : r.message,
                                                                  facts.scenario.names.function()))});
  if (insane.empty() && !sanity.empty()) {
    if (facts.scenario.check.sane)
      findings.push_back({Kind::good, "Sane: no cell is crushed, torn or turned inside out"});
    else findings.push_back({Kind::good, "Need not be sane: " + shown(facts.scenario.check.because)});
  }
}

void judgeDivisions(const RunFacts& facts, std::vector<Finding>& findings) {
  if (facts.ambiguous.empty()) return;
  const DivisionRecord& first = facts.ambiguous.front();
  findings.push_back(
      {Kind::warning, counted(facts.ambiguous.size(), "division") +
                          " along a longest extent that hardly differs from the next one: first of " +
                          shown(facts.scenario.names.of(first.path).value_or(cellName(first.path.text()))) +
                          " at time " + numberText(first.time) + " (ratio " +
                          numberText(*first.extentRatio, 6) +
                          "); another mesh, time step or precision may cut elsewhere"});
}

void judgeAgain(const RunFacts& facts, std::vector<Finding>& findings) {
  if (!facts.again || facts.again->same) return;
  const bool sameBuild = buildId(facts.run.record.build) == buildId(buildInfo());
  findings.push_back({sameBuild ? Kind::bad : Kind::warning,
                      std::string("Run again for this page, it ends in another state than is stored") +
                          (sameBuild ? ", though by the same program"
                                     : ", by another program: pictures and explorer show what this program "
                                       "computes, the tables what is stored")});
}

std::string statusText(const StoredRun& run) {
  if (run.status == RunStatus::running) return "has not ended";
  return std::string(name(run.status)) + ", with " + counted(run.cells, "cell") + " at time " +
         numberText(run.time, 6) + " after " + counted(run.steps, "step");
}

std::string sentenceOf(const std::vector<RunFacts>& runs, bool bad, bool warned) {
  const std::string ending = bad ? "there are faults." : warned ? "there are warnings." : "nothing is amiss.";
  if (runs.size() == 1) return "The run is " + statusText(runs[0].run) + ": " + ending;
  return counted(runs.size(), "run") + ": " + ending;
}

/// Runs of one scenario that differ in their seed, and not in their end.
void judgeSeeds(const std::vector<RunFacts>& runs, std::vector<Finding>& findings) {
  const auto keyOf = [](const RunFacts& r) { return r.run.record.scenario + ' ' + r.run.stateHash; };
  std::map<std::string, std::set<std::uint64_t>> seeds;
  for (const RunFacts& r : runs)
    if (r.run.status == RunStatus::done) seeds[keyOf(r)].insert(r.run.record.seed);
  for (const RunFacts& r : runs) {
    const auto same = seeds.find(keyOf(r));
    if (same == seeds.end() || same->second.size() < 2) continue;
    findings.push_back(
        {Kind::warning,
         counted(same->second.size(), "seed") + " of " + shown(r.run.record.scenario) +
             " gave one and the same result, bit for bit: they are no replicates" +
             (usesSeed(r.scenario.scene) ? "" : ", since nothing in this scenario varies with the seed")});
    seeds.erase(same);  // said
  }
}

std::string runTable(const std::vector<RunFacts>& runs) {
  std::vector<std::vector<std::string>> rows;
  for (const RunFacts& r : runs) {
    const auto failed =
        std::count_if(r.checks.begin(), r.checks.end(), [](const CheckResult& c) { return !c.passed; });
    rows.push_back({shown(r.run.record.scenario), std::to_string(r.run.record.seed), name(r.run.status),
                    std::to_string(r.run.cells), numberText(r.run.time, 6),
                    r.checks.empty() ? "none"
                    : failed ? std::to_string(failed) + " of " + std::to_string(r.checks.size()) + " failed"
                             : "all " + std::to_string(r.checks.size()) + " passed",
                    "<code>" + shown(r.run.stateHash.substr(0, 12)) + "</code>",
                    "<code>" + shown(r.run.id) + "</code>"});
  }
  return htmlTable("Runs", {"Scenario", "Seed", "Status", "Cells", "Time", "Checks", "End state", "Run"},
                   rows);
}

}  // namespace

std::vector<Finding> findingsOf(const RunFacts& facts) {
  std::vector<Finding> findings;
  const StoredRun& run = facts.run;
  if (run.status == RunStatus::failed)
    findings.push_back(
        {facts.scenario.check.fails.empty() ? Kind::bad : Kind::good,
         (facts.scenario.check.fails.empty() ? "The run failed: " : "The run failed, as it has to: ") +
             shown(run.failure)});
  if (run.status == RunStatus::killed)
    findings.push_back({Kind::warning, "The run was interrupted; morula run --resume goes on with it"});
  if (run.status == RunStatus::running)
    findings.push_back(
        {Kind::warning, "The run has not ended, or its program was killed: there are no results yet"});
  judgeChecks(facts, findings);
  judgeDivisions(facts, findings);
  judgeAgain(facts, findings);
  judgeBullet(facts, findings);
  if (!facts.unusableGolden.empty())
    findings.push_back({Kind::warning, "The golden file cannot be used: " + shown(facts.unusableGolden)});
  for (const std::string& warning : facts.scenario.warnings)
    findings.push_back({Kind::warning, shown(warning)});
  return findings;
}

std::string verdictOf(const std::vector<RunFacts>& runs) {
  std::vector<Finding> findings;
  judgeSeeds(runs, findings);
  for (const RunFacts& run : runs)
    for (Finding& f : findingsOf(run)) {
      if (runs.size() > 1) {
        if (f.kind == Kind::good) continue;
        f.html = "<b>" + shown(titleOf(run, runs)) + "</b>: " + f.html;
      }
      findings.push_back(std::move(f));
    }
  const auto has = [&](Kind kind) {
    return std::any_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.kind == kind; });
  };
  return "<p class=\"said\">" + sentenceOf(runs, has(Kind::bad), has(Kind::warning)) + "</p>\n" +
         findingsHtml(findings) + (runs.size() > 1 ? runTable(runs) : "");
}

std::string changeOf(const RunFacts& run) {
  if (run.golden.empty() || run.run.status != RunStatus::done || !run.unusableGolden.empty()) return {};
  if (run.change.empty())
    return "<p>Nothing that the accepted result records, <code>" + shown(run.golden) + "</code>.</p>\n";
  return "<p>Beside the accepted result, <code>" + shown(run.golden) + "</code>:</p>\n<pre tabindex=\"0\">" +
         shown(withNames(run.change, run.scenario.names.function())) + "</pre>\n";
}

std::string checksOf(const std::vector<CheckResult>& checks, const CellNames& names) {
  std::vector<std::vector<std::string>> rows;
  std::string messages;
  for (const CheckResult& r : checks) {
    const std::string where = (r.firstStep ? "step " + std::to_string(*r.firstStep) + " " : "") +
                              (r.cell ? withNames(cellName(*r.cell), names.function()) + " " : "") +
                              (r.passed ? "" : r.field);
    rows.push_back({shown(r.check), shown(r.kind),
                    r.passed ? "<span class=\"mark good\">✓ passed</span>"
                             : "<span class=\"mark bad\">✗ " + shown(r.failureClass) + "</span>",
                    shown(r.tolerance), r.share ? inPercent(*r.share) : "", shown(r.expected),
                    shown(r.actual), shown(where)});
    if (!r.passed && !r.message.empty())
      messages += htmlFolded(
          r.check, "<pre tabindex=\"0\">" + shown(withNames(r.message, names.function())) + "</pre>\n");
  }
  return htmlTable(
             "Checks",
             {"Check", "Kind", "Result", "Tolerance", "Share of it", "Expected", "Found", "First difference"},
             rows) +
         (messages.empty() ? "" : "<h3>What differs</h3>\n" + messages);
}

}  // namespace morula
