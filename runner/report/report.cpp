#include "report/report.h"

#include <algorithm>

#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/read_file.h"
#include "loop/stored_scenario.h"
#include "report/parts.h"
#include "report/run_blocks.h"
#include "report/study_part.h"
#include "report/tables.h"
#include "report/verdict.h"
#include "system/child_process.h"
#include "system/usage_error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

struct Sources {
  std::vector<std::string> databases, studies, checks, accuracies;
};

/// By what a file holds, not by its name. Whether it is one.
bool addSource(const std::string& file, Sources& sources) {
  if (isDatabase(file)) return (isStudy(file) ? sources.studies : sources.databases).push_back(file), true;
  const auto first = readHead(file, 1);
  if (first != "{") return false;
  const Json json = Json::tryParse(readFile(file));
  if (!json.is_object() || !json.contains("morula")) return false;
  if (json.contains("rows") && json.contains("scenario")) return sources.accuracies.push_back(file), true;
  if (json.contains("results")) return sources.checks.push_back(file), true;
  return false;
}

/// What `what` names; the files of a folder sorted by name.
Sources sourcesOf(const std::vector<std::string>& what) {
  Sources sources;
  for (const std::string& name : what) {
    if (!fileExists(name)) throw FileError("'" + name + "': no such file or folder");
    if (!isFolder(name)) {
      if (!addSource(name, sources))
        throw UsageError("'" + name + "' is " + std::string(morula::name(contentOfFile(name))) +
                         "; report needs a database that morula run has written, a report.json of morula "
                         "check --reports, what "
                         "morula accuracy --json has printed, or a folder of these");
      continue;
    }
    bool any = false;
    for (const char* ending : {".db", ".json"})
      for (const fs::path& file : filesBelow(name, ending))
        any = addSource(file.generic_string(), sources) || any;
    // A merged study holds the runs of all of its tasks.
    for (const std::string& study : sources.studies)
      std::erase_if(sources.databases, [tasks = (fs::path(study).parent_path() / "tasks/").generic_string()](
                                           const std::string& file) { return file.starts_with(tasks); });
    if (!any)
      throw UsageError("'" + name + "': no database and no report in this folder; morula run writes one");
  }
  return sources;
}

std::vector<RunFacts> factsOfAll(const Sources& sources, const ReportQuestion& question) {
  std::vector<RunFacts> facts;
  for (const std::string& file : sources.databases) {
    auto store = Store::openForReading(file);
    const auto runs = question.run.empty() ? store.runs() : std::vector{store.find(question.run)};
    for (const StoredRun& run : runs) facts.push_back(factsOf(store, run));
  }
  for (const std::string& file : sources.studies) {
    auto store = Store::openForReading(file);
    const std::size_t most = mostExplored - std::min(mostExplored, facts.size());
    for (const Representative& r : representativesOf(file, most)) {
      facts.push_back(factsOf(store, store.find(r.run)));
      facts.back().label = r.condition;
    }
  }
  if (facts.empty() && sources.studies.empty() && sources.checks.empty() && sources.accuracies.empty())
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

ExplorerRun explorerRunOf(const CheckedScenario& checked) {
  const World& world = checked.again->simulation.world;
  return {.title = checked.report.scenario,
          .scenario = &checked.again->scenario,
          .lineage = &world.lineage.entries,
          .describe = [&world](StateId state) { return world.biology->describe(state); },
          .end = checked.again->simulation.end.time,
          .frames = &checked.again->frames};
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

/// All of a page but its frames.
PagePart runPart(const std::vector<RunFacts>& runs, std::size_t mostBytes) {
  PagePart part{.title = titleOfPage(runs),
                .summary = printable(runs[0].scenario.summary),
                .verdict = {},
                .change = {},
                .blocks = {}};
  const auto heading = [&](const RunFacts& run) {
    return runs.size() > 1 ? "<h3>" + shown(titleOf(run, runs)) + "</h3>\n" : std::string();
  };
  // What is said of a study is said of all of its runs, not of those that stand for its conditions.
  if (std::any_of(runs.begin(), runs.end(), [](const RunFacts& r) { return r.label.empty(); }))
    part.verdict = verdictOf(runs);
  std::string changes, checks;
  for (const RunFacts& run : runs) {
    if (const std::string change = changeOf(run);
        !change.empty() && (runs.size() == 1 || !run.change.empty()))
      changes += heading(run) + change;
    const bool differs =
        std::any_of(run.checks.begin(), run.checks.end(), [](const CheckResult& c) { return !c.passed; });
    if (!run.checks.empty() && (runs.size() <= mostExplored || differs))
      checks += heading(run) + checksOf(run.checks, run.scenario.names);
  }
  if (!changes.empty()) part.change.push_back({"change", "What changed", changes, {}});
  part.blocks = {pictureBlock(runs), chartBlock(runs)};
  if (!checks.empty()) {
    part.blocks.push_back({"checks", "Checks", checks, {}});
    if (runs.size() == 1 && !runs[0].golden.empty())
      part.blocks.back().commands = {"./morula check " + shellWord(sourceOf(runs[0])),
                                     "./morula explain " + shellWord(sourceOf(runs[0]))};
  }
  part.blocks.push_back(provenanceBlock(runs));
  part.blocks.push_back(parameterBlock(runs));
  part.blocks.push_back(downloadBlock(runs, mostBytes / 10));
  return part;
}

/// The parts, one after the other: what must be known first of each, then the explorer, then the rest.
void putTogether(const std::vector<PagePart>& parts, const PageBlock* explorer, Page& page) {
  page.verdict.clear(), page.blocks.clear();
  for (const PagePart& part : parts) page.verdict += part.verdict;
  for (const PagePart& part : parts)
    page.blocks.insert(page.blocks.end(), part.change.begin(), part.change.end());
  if (explorer) page.blocks.push_back(*explorer);
  for (const PagePart& part : parts)
    page.blocks.insert(page.blocks.end(), part.blocks.begin(), part.blocks.end());
}

}  // namespace

void findExplorer(ReportQuestion& question) {
  const fs::path file = fs::path(ownProgram()).parent_path() / "explorer" / "explorer.js";
  if (isPlainFile(file)) question.program = readFile(file);
  else
    question.whyNone =
        "./morula report builds it where Node.js and npm are (Debian: nodejs, npm), and has not";
}

ReportAnswer makeReport(const ReportQuestion& question) {
  const Sources sources = sourcesOf(question.what);
  std::vector<RunFacts> runs = factsOfAll(sources, question);
  ReportAnswer answer{.bytes = {}, .runs = runs.size(), .remarks = {}};
  std::vector<PagePart> parts;
  std::vector<ExplorerRun> explored;
  std::vector<Frames*> frames;

  std::vector<std::vector<CheckedScenario>> checks;
  for (const std::string& file : sources.checks) {
    checks.push_back(readChecked(file));
    if (question.frames > 0 && (answer.signal = runFailedAgain(checks.back(), mostExplored / 2, question)))
      return answer;
    parts.push_back(checkPart(checks.back(), file));
  }
  for (auto& checked : checks)
    for (CheckedScenario& c : checked)
      if (c.again && explored.size() < mostExplored)
        explored.push_back(explorerRunOf(c)), frames.push_back(&c.again->frames);

  std::size_t again = explored.size();
  for (RunFacts& run : runs)
    if (question.frames > 0 && again < mostExplored && canRunAgain(run)) {
      ++again;
      if ((answer.signal = runAgain(run, question.execution, question.frames, question.quiet))) return answer;
      frames.push_back(&run.again->frames);
    }
  for (const RunFacts& run : runs)
    if (!run.results.lineage.empty() && explored.size() < mostExplored && (run.again || again == 0))
      explored.push_back(explorerRunOf(run, runs));
  for (const std::string& file : sources.studies) parts.push_back(studyPart(file));
  if (!runs.empty()) parts.push_back(runPart(runs, question.mostBytes));
  for (const std::string& file : sources.accuracies) parts.push_back(accuracyPart(file));
  if (runs.empty()) parts.back().blocks.push_back(programBlock());

  Page page{.title = parts.front().title,
            .summary = parts.front().summary,
            .verdict = {},
            .blocks = {},
            .data = {},
            .bytes = {},
            .program = explored.empty() ? "" : question.program};
  const auto compose = [&] {
    const PageBlock explorer = explorerBlock(question, explored);
    putTogether(parts, explored.empty() ? nullptr : &explorer, page);
    if (!page.program.empty()) page.data = jsonText(explorerData(explored));
  };
  // What room the rest leaves goes to the frames; base64 takes 4 bytes for 3.
  compose();
  const std::size_t without = pageFile(page).size() + 20'000;
  const std::size_t room = question.mostBytes > without ? (question.mostBytes - without) / 4 * 3 : 0;
  for (Frames* of : frames) thinFrames(*of, page.program.empty() ? 0 : room / frames.size());
  compose();
  if (!page.program.empty()) page.bytes = explorerBytes(explored);
  answer.bytes = pageFile(page);
  if (answer.bytes.size() > question.mostBytes)
    answer.remarks.push_back("the page takes " + std::to_string(answer.bytes.size()) +
                             " bytes, more than --size-limit");
  for (const ExplorerRun& run : explored)
    if (const Frames* f = run.frames; f && !page.program.empty() && f->frames.size() < f->worlds.size())
      answer.remarks.push_back(run.title + ": " + std::to_string(f->frames.size()) + " of " +
                               std::to_string(f->worlds.size()) + " frames fit into the page");
  return answer;
}

}  // namespace morula
