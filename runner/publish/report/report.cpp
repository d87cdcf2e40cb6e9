#include "report/report.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "loop/stored_scenario.h"
#include "report/bullet_block.h"
#include "report/explored.h"
#include "report/page_parts.h"
#include "report/run_blocks.h"
#include "report/study_part.h"
#include "system/installation.h"
#include "system/json.h"
#include "system/usage_error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

struct Sources {
  std::vector<std::string> databases, studies, checks, accuracies;  // paths of files
};

/// Adds a source by the file's content, not by its name. Returns false if the file is no source.
bool addSource(const std::string& file, Sources& sources) {
  const std::string head = readBeginning(file, 16);
  if (contentOf(head) == Content::database)
    return (isMergedStudy(file) ? sources.studies : sources.databases).push_back(file), true;
  if (!head.starts_with('{')) return false;
  const Json json = tryParseJson(readFile(file));
  if (!json.is_object() || !json.contains("morula")) return false;
  if (json.contains("rows") && json.contains("scenario")) return sources.accuracies.push_back(file), true;
  if (json.contains("results")) return sources.checks.push_back(file), true;
  return false;
}

/// Returns the sources that `what` names; the files of a folder are sorted by name. Throws FileError for a missing
/// file, UsageError for a file that no report can be about.
Sources sourcesOf(const std::vector<std::string>& what) {
  Sources sources;
  for (const std::string& name : what) {
    if (!fileExists(name)) throw FileError("'" + name + "': no such file or folder");
    if (!isFolder(name)) {
      if (!addSource(name, sources))
        throw UsageError("'" + name + "' is " + std::string(morula::name(contentOfFile(name))) +
                         "; report needs a database that morula run has written, a report.json of morula check "
                         "--reports, what morula accuracy --json has printed, or a folder of these");
      continue;
    }
    bool any = false;
    for (const char* ending : {".db", ".json"})
      for (const fs::path& file : filesBelow(name, ending)) any = addSource(file.generic_string(), sources) || any;
    // A merged study holds the runs of all of its tasks.
    for (const std::string& study : sources.studies)
      std::erase_if(sources.databases, [tasks = (fs::path(study).parent_path() / "tasks/").generic_string()](
                                           const std::string& file) { return file.starts_with(tasks); });
    if (!any) throw UsageError("'" + name + "': no database and no report in this folder; morula run writes one");
  }
  return sources;
}

struct AllFacts {
  std::vector<RunFacts> runs, more;         // `more`: further runs of studies, only for the explorer
  std::vector<std::size_t> ofStudies = {};  // how many runs each study has
};

/// Returns the runs of a study that the page shows: all, or the run that `wanted` names.
std::vector<Representative> chosenOf(const std::vector<Representative>& all, Store& store, const std::string& wanted) {
  if (wanted.empty()) return all;
  auto found = std::ranges::find_if(all, [&](const Representative& r) { return r.name() == wanted; });
  if (found == all.end()) found = std::ranges::find(all, store.find(wanted).id, &Representative::run);
  if (found == all.end()) throw UsageError("--run: " + wanted + " did not come to its end");
  return {*found};
}

AllFacts factsOfAll(const Sources& sources, const ReportQuestion& question) {
  AllFacts facts;
  for (const std::string& file : sources.databases) {
    auto store = Store::openForReading(file);
    const auto runs = question.run.empty() ? store.runs() : std::vector{store.find(question.run)};
    for (const StoredRun& run : runs) facts.runs.push_back(factsOf(store, run));
  }
  for (const std::string& file : sources.studies) {
    auto store = Store::openForReading(file);
    const auto all = representativesOf(file);
    facts.ofStudies.push_back(all.size());
    for (const Representative& r : chosenOf(all, store, question.run)) {
      if (facts.runs.size() + facts.more.size() >= std::max(maxExplored, question.explored)) break;
      std::vector<RunFacts>& to = facts.runs.size() < maxExplored ? facts.runs : facts.more;
      to.push_back(factsOf(store, store.find(r.run)));
      to.back().label = r.condition;
    }
  }
  nameRuns(facts.runs);
  nameRuns(facts.more);
  if (facts.runs.empty() && sources.studies.empty() && sources.checks.empty() && sources.accuracies.empty())
    throw UsageError("there is no run in " + question.what.front() + "; morula run writes one");
  return facts;
}

/// Adds a note on the runs of a study in the explorer, and on how to see the others.
void sayWhichOfStudies(const Sources& sources, const AllFacts& facts, const std::vector<ExplorerRun>& shown,
                       Document& body) {
  for (std::size_t i = 0; i < sources.studies.size(); ++i) {
    const std::string& file = sources.studies[i];
    std::size_t here = 0;
    for (const auto* runs : {&facts.runs, &facts.more})
      for (const RunFacts& run : *runs)
        here += run.database == file &&
                std::ranges::any_of(shown, [&](const ExplorerRun& e) { return e.scenario == &run.scenario; });
    if (here == facts.ofStudies[i]) continue;
    body.note(std::to_string(here) + " of " + counted(facts.ofStudies[i], "run") +
              " are here, first the conditions that differ most. --explore N and --size-limit give more; any other "
              "run: " +
              programWord() + " report " + shellWord(file) + " --run 'CONDITION, seed N' -o page.html");
  }
}

/// Returns the runs of studies in the explorer, each with a link that shows it there and the command for a page of it
/// alone; empty without such runs.
Document ownPages(const AllFacts& facts, const std::vector<ExplorerRun>& shown) {
  Table table{"Runs of the explorer", {"run", "command for a page of this run alone"}};
  for (std::size_t i = 0; i < shown.size(); ++i)
    for (const auto* runs : {&facts.runs, &facts.more})
      for (const RunFacts& run : *runs)
        if (&run.scenario == shown[i].scenario && !run.label.empty() && titleOf(run) == shown[i].title)
          table.rows.push_back({Words(shown[i].title, Emphasis::link, "left=" + std::to_string(i)),
                                code(commandFor(run, "report", "-o run.html"))});
  if (table.rows.empty()) return {};
  const std::string title = "Pages of " + counted(table.rows.size(), "run");
  return Document().add(folded(title, Document().add(std::move(table))));
}

PageSection explorerSection(const ReportQuestion& question, const Sources& sources, const AllFacts& facts,
                            const std::vector<ExplorerRun>& runs) {
  PageSection section{"explorer", "Explorer", {}};
  if (question.program.empty()) section.body.say("This page has no explorer: " + question.whyNone);
  else section.body.add(ExplorerPlace{}).add(leftOutOf(runs));
  section.body.add(ownPages(facts, runs));
  sayWhichOfStudies(sources, facts, runs, section.body);
  return section;
}

/// Returns "1 check, 2 studies and 3 runs".
std::string titleOfParts(const Sources& sources, std::size_t runs) {
  std::vector<std::string> texts;
  const auto add = [&](std::size_t count, const std::string& one, const std::string& several) {
    if (count) texts.push_back(std::to_string(count) + ' ' + (count == 1 ? one : several));
  };
  add(sources.checks.size(), "check", "checks");
  add(sources.studies.size(), "study", "studies");
  add(runs, "run", "runs");
  add(sources.accuracies.size(), "accuracy run", "accuracy runs");
  return listed(texts);
}

std::string commandOf(const ReportQuestion& question) {
  static const ReportQuestion usual;
  std::string command = programWord() + " report";
  for (const std::string& what : question.what) command += ' ' + shellWord(what);
  if (!question.run.empty()) command += " --run " + shellWord(question.run);
  if (question.explored != usual.explored) command += " --explore " + std::to_string(question.explored);
  if (question.frames != usual.frames) command += " --frames " + std::to_string(question.frames);
  if (question.maxBytes != usual.maxBytes) command += " --size-limit " + std::to_string(question.maxBytes);
  if (!question.bullet) command += " --no-bullet";
  if (question.rerun) command += " --rerun";
  return command + " -o page.html";
}

/// Fills the page: the verdict and the changes of each part, the explorer, and then the other sections of each part.
/// Titles of sections name their part, unless all are from `one` source. With `appendix` long tables follow all others.
void putTogether(const std::vector<PagePart>& parts, bool one, bool appendix, const std::vector<PageSection>& explorer,
                 Page& page) {
  page.verdict.clear(), page.blocks.clear();
  std::map<std::string, int> known;  // number of uses of each id
  const auto add = [&](const PageSection& section, const std::string& part) {
    const int count = ++known[section.id];
    page.blocks.push_back({section.id + (count > 1 ? "-" + std::to_string(count) : ""),
                           section.title + (part.empty() ? "" : ": " + part), htmlOf(section.body), section.commands});
  };
  const auto titleOf = [&](const PagePart& part) { return !one || part.isAside ? part.title : ""; };
  for (const PagePart& part : parts)
    if (!part.verdict.empty())
      page.verdict +=
          (one ? "" : htmlOf(Document().add(Sentence{part.title, Sentence::Kind::part}))) + htmlOf(part.verdict);
  for (const PagePart& part : parts)
    for (const PageSection& section : part.change) add(section, titleOf(part));
  for (const PageSection& section : explorer) add(section, "");
  static const std::set<std::string> lists{"comparison", "provenance", "parameters", "downloads"};
  for (const bool last : {false, true}) {
    if (last && appendix)
      page.blocks.push_back({"appendix", "Appendix", htmlOf(Document().note("Tables, provenance and parameters.")), {}});
    for (const PagePart& part : parts)
      for (const PageSection& section : part.sections)
        if ((appendix && lists.contains(section.id)) == last) add(section, titleOf(part));
  }
}

/// Throws UsageError unless there is exactly one run, which a page can repeat.
void demandOneRun(const std::vector<RunFacts>& runs) {
  if (runs.size() != 1)
    throw UsageError("report --rerun: a page makes one run again, and this one has " + std::to_string(runs.size()) +
                     (runs.empty() ? "" : "; choose one with --run"));
  if (const std::string why = whyNoRerun(runs[0]); !why.empty())
    throw UsageError("report --rerun: run " + runs[0].run.id + " cannot be made again in a page: " + why);
}

}  // namespace

void findExplorer(ReportQuestion& question) {
  const auto file = sharedFile(question.rerun ? "explorer/rerun.js" : "explorer/explorer.js");
  if (file) question.program = readFile(*file);
  else
    question.whyNone =
        installation() ? "the installation does not have it"
                       : "`./morula report` in the sources builds it where Node.js and npm are (Debian: nodejs, npm)";
  if (!question.rerun) return;
  if (!file) throw FileError("report --rerun: the explorer of pages that run again is missing; " + question.whyNone);
  const auto module = sharedFile("wasm/morula.wasm.gz");
  if (!module)
    throw FileError(std::string("report --rerun: the simulator for pages is not built; ") +
                    (installation() ? "the installation does not have it"
                                    : "`./morula wasm` in the sources builds it (Debian: emscripten)"));
  question.module = readFile(*module);
}

ReportAnswer makeReport(const ReportQuestion& question) {
  const Sources sources = sourcesOf(question.what);
  AllFacts facts = factsOfAll(sources, question);
  std::vector<RunFacts>& runs = facts.runs;
  if (question.rerun) demandOneRun(runs);
  ReportAnswer answer{.bytes = {}, .runs = runs.size(), .remarks = {}};
  std::vector<PagePart> parts;
  Explored explored;

  std::vector<std::vector<CheckedScenario>> checks;
  for (const std::string& file : sources.checks) {
    checks.push_back(readChecked(file));
    if (question.frames > 0) runFailedAgain(checks.back(), maxExplored / 2, question);
    if (question.frames > 0 && question.bullet) runCheckedInBullet(checks.back(), question);
    parts.push_back(checkPart(checks.back(), file));
    for (PageSection& section : bulletSections(checks.back())) parts.back().sections.push_back(std::move(section));
  }
  for (auto& checked : checks) exploreChecked(checked, explored);
  exploreRuns(runs, question, explored);
  if (question.frames > 0) exploreMore(facts.more, question, explored);
  if (runs.size() == 1) drawBeside(runs[0], question.execution, question.quiet);
  for (const std::string& file : sources.studies) {
    parts.push_back(studyPart(file));
    if (question.frames > 0) addOrganisms(parts.back(), file, question.quiet);
  }
  if (!runs.empty()) parts.push_back(runPart(runs, question.maxBytes));
  for (const std::string& file : sources.accuracies) parts.push_back(accuracyPart(file));
  if (runs.empty()) parts.back().sections.push_back(programSection());

  // Runs with a label represent a study's conditions, and are counted with the study.
  const auto own = static_cast<std::size_t>(
      std::count_if(runs.begin(), runs.end(), [](const RunFacts& r) { return r.label.empty(); }));
  const bool one = sources.checks.size() + sources.studies.size() + sources.accuracies.size() + (own > 0) == 1;
  Page page{.title = one ? parts.front().title : titleOfParts(sources, own),
            .summary = one ? parts.front().summary : "",
            .verdict = {},
            .blocks = {},
            .data = {},
            .bytes = {},
            .command = commandOf(question),
            .program = explored.runs.empty() ? "" : question.program,
            .runsAgain = question.rerun};
  const auto compose = [&] {
    std::vector<PageSection> explorer;
    if (!explored.runs.empty()) explorer.push_back(explorerSection(question, sources, facts, explored.runs));
    if (question.rerun) explorer.push_back(rerunSection(runs[0]));
    putTogether(parts, one, !sources.studies.empty(), explorer, page);
    if (page.program.empty()) return;
    Json data = explorerData(explored.runs);
    for (const PagePart& part : parts)
      if (!part.charts.empty()) data["charts"] = part.charts;
    page.data = jsonText(data);
  };
  // Frames get the rest of the page's bytes; base64 takes 4 bytes for 3.
  if (question.rerun) page.bytes = rerunBytes(runs[0], question.module);
  compose();
  const std::size_t without = pageFile(page).size() + 20'000;
  const std::size_t room = question.maxBytes > without ? (question.maxBytes - without) / 4 * 3 : 0;
  for (Frames* of : explored.frames) {
    const std::size_t share = page.program.empty() ? 0 : room / explored.frames.size();
    if (!sources.studies.empty() && packedFrames(*of).size() > share) dropVertexForces(*of);  // for more moments
    thinFrames(*of, share);
  }
  compose();
  if (!page.program.empty())
    for (PageBytes& bytes : explorerBytes(explored.runs)) page.bytes.push_back(std::move(bytes));
  answer.bytes = pageFile(page);
  if (answer.bytes.size() > question.maxBytes)
    answer.remarks.push_back("the page takes " + std::to_string(answer.bytes.size()) +
                             " bytes, more than --size-limit");
  if (const std::string thinned = thinnedText(explored.runs); !thinned.empty() && !page.program.empty())
    answer.remarks.push_back(thinned);
  return answer;
}

}  // namespace morula
