#include "report/report.h"

#include <algorithm>

#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/printable.h"
#include "loop/stored_scenario.h"
#include "report/explorer_data.h"
#include "report/run_blocks.h"
#include "report/tables.h"
#include "report/verdict.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

/// The databases that `what` names, those of a folder sorted by name.
std::vector<std::string> databasesOf(const std::vector<std::string>& what) {
  std::vector<std::string> files;
  for (const std::string& name : what) {
    if (!isFolder(name)) {
      if (!fileExists(name)) throw FileError("'" + name + "': no such file or folder");
      if (!isDatabase(name))
        throw UsageError("'" + name + "' is " + std::string(morula::name(contentOfFile(name))) +
                         "; report needs a database that morula run has written, or a folder of them");
      files.push_back(name);
      continue;
    }
    const std::size_t before = files.size();
    for (const fs::path& file : filesBelow(name, ".db")) files.push_back(file.generic_string());
    if (files.size() == before)
      throw UsageError("'" + name + "': no database in this folder; morula run writes one");
  }
  return files;
}

std::vector<RunFacts> factsOfAll(const ReportQuestion& question) {
  std::vector<RunFacts> facts;
  for (const std::string& file : databasesOf(question.what)) {
    auto store = Store::openForReading(file);
    const auto runs = question.run.empty() ? store.runs() : std::vector{store.find(question.run)};
    for (const StoredRun& run : runs) facts.push_back(factsOf(store, run));
  }
  if (facts.empty())
    throw UsageError("there is no run in " + question.what.front() + "; morula run writes one");
  return facts;
}

ExplorerRun explorerRunOf(const RunFacts& facts, const std::vector<RunFacts>& all) {
  ExplorerRun run{.title = titleOf(facts, all),
                  .scenario = &facts.scenario,
                  .lineage = &facts.results.lineage,
                  .describe = [&facts](StateId state) { return facts.results.stateTexts.at(state); },
                  .end = facts.run.time,
                  .frames = nullptr};
  if (!facts.again) return run;
  const World& world = facts.again->simulation.world;
  run.lineage = &world.lineage.entries;
  run.describe = [&world](StateId state) { return world.biology->describe(state); };
  run.frames = &facts.again->frames;
  return run;
}

std::string titleOfPage(const std::vector<RunFacts>& runs) {
  const std::string& first = runs[0].run.record.scenario;
  const bool same =
      std::all_of(runs.begin(), runs.end(), [&](const auto& r) { return r.run.record.scenario == first; });
  if (runs.size() == 1) return titleOf(runs[0], runs);
  return same ? first + ", " + counted(runs.size(), "run") : counted(runs.size(), "run");
}

PageBlock explorerBlock(const ReportQuestion& question, const std::vector<ExplorerRun>& runs) {
  std::string html;
  if (question.program.empty())
    html = "<p>This page was made without its explorer: " + shown(question.whyNone) + "</p>\n";
  else
    html =
        "<noscript><p>The explorer needs JavaScript; the pictures below do without.</p></noscript>\n<div "
        "id=\"explore\"></div>\n" +
        leftOutOf(runs);
  return {"explorer", "Explorer", html, {}};
}

}  // namespace

ReportAnswer makeReport(const ReportQuestion& question) {
  std::vector<RunFacts> runs = factsOfAll(question);
  ReportAnswer answer{.bytes = {}, .runs = runs.size(), .remarks = {}};
  std::size_t explored = 0;
  for (RunFacts& run : runs) {
    if (question.frames == 0 || explored >= mostExplored) break;
    if (!canRunAgain(run)) continue;
    ++explored;
    if (const int signal = runAgain(run, question.execution, question.frames, question.quiet)) {
      answer.signal = signal;
      return answer;
    }
  }

  Page page{.title = titleOfPage(runs),
            .summary = printable(runs[0].scenario.summary),
            .verdict = verdictOf(runs),
            .blocks = {},
            .data = {},
            .bytes = {},
            .program = question.program};
  std::vector<ExplorerRun> shownRuns;
  for (const RunFacts& run : runs)
    if (!run.results.lineage.empty() && shownRuns.size() < mostExplored && (run.again || explored == 0))
      shownRuns.push_back(explorerRunOf(run, runs));
  if (shownRuns.empty()) page.program.clear();

  std::string changes;
  for (const RunFacts& run : runs)
    if (const std::string change = changeOf(run);
        !change.empty() && (runs.size() == 1 || !run.change.empty()))
      changes += (runs.size() > 1 ? "<h3>" + shown(titleOf(run, runs)) + "</h3>\n" : "") + change;
  PageBlock checks{"checks", "Checks", "", {}};
  for (const RunFacts& run : runs)
    if (!run.checks.empty() &&
        (runs.size() <= mostExplored ||
         !std::all_of(run.checks.begin(), run.checks.end(), [](const auto& c) { return c.passed; })))
      checks.html += (runs.size() > 1 ? "<h3>" + shown(titleOf(run, runs)) + "</h3>\n" : "") +
                     checksOf(run.checks, run.scenario.names);
  if (runs.size() == 1 && !runs[0].golden.empty())
    checks.commands = {"./morula check " + shellWord(sourceOf(runs[0])),
                       "./morula explain " + shellWord(sourceOf(runs[0]))};

  const auto blocks = [&] {
    page.blocks.clear();
    if (!shownRuns.empty()) page.blocks.push_back(explorerBlock(question, shownRuns));
    if (!changes.empty()) page.blocks.push_back({"change", "What changed", changes, {}});
  };
  std::vector<PageBlock> rest{pictureBlock(runs), chartBlock(runs)};
  if (!checks.html.empty()) rest.push_back(checks);
  rest.push_back(provenanceBlock(runs));
  rest.push_back(parameterBlock(runs));
  rest.push_back(downloadBlock(runs, question.mostBytes / 10));

  // What room the rest leaves goes to the frames; base64 takes 4 bytes for 3.
  blocks();
  page.blocks.insert(page.blocks.end(), rest.begin(), rest.end());
  if (!page.program.empty()) page.data = jsonText(explorerData(shownRuns));
  const std::size_t without = pageFile(page).size() + 20'000;
  const std::size_t room = question.mostBytes > without ? (question.mostBytes - without) / 4 * 3 : 0;
  for (RunFacts& run : runs)
    if (run.again)
      thinFrames(run.again->frames, page.program.empty() ? 0 : room / std::max<std::size_t>(1, explored));
  blocks();
  page.blocks.insert(page.blocks.end(), rest.begin(), rest.end());
  if (!page.program.empty()) {
    page.data = jsonText(explorerData(shownRuns));
    page.bytes = explorerBytes(shownRuns);
  }
  answer.bytes = pageFile(page);
  if (answer.bytes.size() > question.mostBytes)
    answer.remarks.push_back("the page takes " + std::to_string(answer.bytes.size()) +
                             " bytes, more than --size-limit");
  for (std::size_t i = 0; i < shownRuns.size(); ++i)
    if (const Frames* f = shownRuns[i].frames;
        f && !page.program.empty() && f->frames.size() < f->worlds.size())
      answer.remarks.push_back(shownRuns[i].title + ": " + std::to_string(f->frames.size()) + " of " +
                               std::to_string(f->worlds.size()) + " frames fit into the page");
  return answer;
}

}  // namespace morula
