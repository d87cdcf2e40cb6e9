#include "report/study_part.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/organisms.h"
#include "analysis/study_comparison.h"
#include "charts/small_multiples.h"
#include "check/remarks.h"
#include "database/database.h"
#include "database/store_error.h"
#include "division/division_record.h"
#include "files/read_file.h"
#include "loop/stored_scenario.h"
#include "store/store.h"
#include "system/installation.h"
#include "system/signals.h"
#include "system/usage_error.h"

namespace morula {
namespace {

constexpr std::size_t maxDrawn = 12;      // max number of conditions with a run simulated again
constexpr std::size_t maxShown = 24;      // max number of stored pictures
constexpr std::size_t maxDownload = 100'000;  // [byte] the section's commands make larger files
constexpr std::size_t maxSentences = 16;  // max number of sentences that are not folded

Database openStudy(const std::string& file) {
  return Database(file, Database::Mode::existing, std::chrono::milliseconds(30'000));
}

/// Draws a chart for each measure, as wide as a telephone, and one key of shapes and colours.
Document stripsDocument(const StudyComparison& c, const Units& units) {
  SmallMultiples all = stripsOf(c, units);
  Document document, charts;
  document.note(all.words.caption);
  // The key shows shapes as letters, so that it is legible in grey, too.
  static const std::map<Marker, std::string> letters{
      {Marker::disc, "●"},    {Marker::square, "■"}, {Marker::triangle, "▲"}, {Marker::diamond, "◆"},
      {Marker::hanging, "▼"}, {Marker::plus, "✚"},   {Marker::ring, "○"}};
  LineKey key;
  for (const LegendEntry& entry : all.words.legend)
    key.lines.push_back({entry.colour, false, letters.at(entry.marker) + " " + entry.label});
  if (!key.lines.empty()) document.add(std::move(key));
  for (Panel& panel : all.panels) {
    const std::string what = panel.title + ": all values of each condition, with their means and 95 % intervals";
    charts.add(svgPicture(drawSmallMultiples({.words = {}, .panels = {std::move(panel)}}), what, ""));
  }
  return document.add(Group{Group::Kind::charts, "", std::move(charts)});
}

struct Trouble {
  std::string condition;
  TaskStatus status;
  std::string reason;
  auto operator<=>(const Trouble&) const = default;
};

/// Adds findings on runs that failed, are missing or are not sane, one for each condition and reason.
void judgeTasks(const StudyResults& r, std::vector<Finding>& findings) {
  std::vector<std::pair<Trouble, std::vector<std::string>>> found;  // each trouble with the seeds of its runs
  for (const auto& [condition, seed, task] : troubledRuns(r)) {
    const Trouble trouble{condition, task.status, task.reason};
    auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == trouble; });
    if (same == found.end()) same = found.insert(found.end(), {trouble, {}});
    same->second.push_back(std::to_string(seed));
  }
  for (const auto& [trouble, seeds] : found) {
    const Words which =
        bold(trouble.condition) + ", " + (seeds.size() == 1 ? "seed " : "seeds ") + listed(seeds, 12) + ": ";
    if (trouble.status == TaskStatus::done)
      findings.push_back({Finding::Kind::bad,
                          which + "not sane: " +
                              (trouble.reason.empty() ? "the final state of bodies is not possible" : trouble.reason) +
                              ". The values of this run are included"});
    else if (trouble.status == TaskStatus::missing)
      findings.push_back({Finding::Kind::warning, which + "missing; morula study run continues the study"});
    else {
      Finding failed = failedBecause(Finding::Kind::bad, trouble.reason.empty() ? "" : ": ", trouble.reason);
      failed.words = which + nameOf(trouble.status) + failed.words;
      findings.push_back(std::move(failed));
    }
  }
}

/// Adds findings on conditions with the same runs, and on conditions in which seeds change nothing.
void judgeConditions(const StudyComparison& c, std::vector<Finding>& findings) {
  const StudyResults& r = c.results;
  for (const auto& names : namesOfSameRuns(r)) {
    std::vector<Words> bolds;
    for (const std::string& name : names) bolds.push_back(bold(name));
    findings.push_back({Finding::Kind::warning, listed(bolds, 12) + " have the same runs"});
  }
  for (const std::size_t k : c.seedless)
    findings.push_back({Finding::Kind::warning, "Seeds change nothing under " + bold(r.nameOf(r.conditions[k])) +
                                                    ": its replicates are one run, and its mean has no interval"});
}

/// Adds findings on runs with divisions whose axis is ambiguous.
void judgeDivisions(const StudyResults& r, const std::string& database, std::vector<Finding>& findings) {
  std::set<std::string> suspects;
  {
    Database db = openStudy(database);
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
      requireWholeRecord(store, run);
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
                            ": the longest extent of a mother is hardly longer than her next one, so another mesh, "
                            "time step or precision may cut elsewhere"});
}

/// Returns true if the first finished run has bodies; false if no run is done.
bool hasBodies(const StudyResults& results, const std::string& database) {
  for (const ResultTask& task : results.tasks)
    if (task.status == TaskStatus::done) return storedScenario(database, task.runId).scene.mechanics.has_value();
  return false;
}

}  // namespace

bool isMergedStudy(const std::string& database) {
  Database db = openStudy(database);
  return db.integer(
             "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('study', 'replicate', "
             "'result')") == 3;
}

PagePart studyPart(const std::string& database) {
  const StudyComparison c = compareStudy(readStudyResults(database), {});
  const StudyResults& r = c.results;
  std::size_t done = 0;
  for (const ResultTask& task : r.tasks) done += task.status == TaskStatus::done;
  PagePart part{.title = "Study " + r.name,
                .summary = r.summary,
                .verdict = verdict(std::to_string(done) + " of " + counted(r.tasks.size(), "distinct run") +
                                       (r.tasks.size() == 1 ? " is" : " are") +
                                       " done: " + counted(r.conditions.size(), "condition") + ", " +
                                       counted(r.seeds.size(), "seed") + ".",
                                   findingsOf(c, database))};
  const StudyComparison shown = inUnits(c, unitsOf(r, database));
  const std::vector<std::string> sentences = verdictsOf(shown);
  PlainList said, more;
  for (std::size_t i = 0; i < sentences.size(); ++i) (i < maxSentences ? said : more).list.push_back(sentences[i]);
  Document findings;
  if (said.list.empty()) findings.say("Nothing: no measure has values.");
  else findings.add(std::move(said));
  if (!more.list.empty()) {
    const std::string title = counted(more.list.size(), "more sentence");
    findings.add(folded(title, Document().add(std::move(more))));
  }
  if (const std::string units = unitsInWords(shown); !units.empty()) findings.say(units);
  findings.add(interactionTables(shown));
  findings.heading("Measures").add(measureTable(shown));
  const std::string file = shellWord(database);
  part.change.push_back(
      {"findings", "Findings of the study", std::move(findings), {programWord() + " study compare " + file}});
  part.sections.push_back({"strips",
                           "Every value",
                           stripsDocument(c, shown.units),
                           {programWord() + " study compare " + file + " -o strips.svg"}});
  Document body = comparedTables(shown);
  Downloads downloads;
  for (Downloads::File file :
       {Downloads::File{"comparison.csv", "text/csv", toCsv(c)},
        Downloads::File{"comparison.json", "application/json", jsonText(toJson(c, shown.units), 1)}})
    if (file.bytes.size() <= maxDownload) downloads.files.push_back(std::move(file));
  body.add(std::move(downloads));
  part.sections.push_back({"comparison",
                           "Comparison",
                           std::move(body),
                           {programWord() + " study compare " + file + " --csv > comparison.csv",
                            programWord() + " study compare " + file + " --json > comparison.json"}});
  return part;
}

void addOrganisms(PagePart& part, const std::string& database, bool quiet) {
  const StudyResults results = readStudyResults(database);
  PageSection section{
      "organisms", "Organisms", {}, {programWord() + " compare " + shellWord(database) + " --pictures grid.png"}};
  if (const auto stored = storedPictures(results, database)) {
    Document pictures;
    std::vector<std::size_t> order = byDifference(compareStudy(results, {}));
    order.resize(std::min(maxShown, order.size()));
    for (const std::size_t k : order)
      pictures.add(Picture{"image/png", readFile(stored->files[k]),
                           "the organism at the end of " + results.nameOf(results.conditions[k]),
                           results.nameOf(results.conditions[k])});
    section.body.note("The organisms at the end, with seed " + std::to_string(results.seeds[stored->seed]) +
                      ": the pictures that the study keeps in " + stored->files[0].parent_path().generic_string() +
                      (stored->files.size() > maxShown ? "; the first " + std::to_string(maxShown) + " of " +
                                                             counted(stored->files.size(), "condition")
                                                       : "") +
                      ". Each has a scale bar of its own.");
    section.body.add(Group{Group::Kind::charts, "", std::move(pictures)});
  } else {
    if (!whyTooMany(results, {}).empty() || !hasBodies(results, database)) return;
    if (results.conditions.size() > maxDrawn) {
      section.body.note(counted(results.conditions.size(), "condition") +
                        " are too many to be repeated for this page; the command draws them.");
    } else {
      try {
        for (const Drawing& page : drawOrganisms(results, database, {}, quiet))
          section.body.add(pngPicture(page.pixels(), "the organisms of all conditions at five moments",
                                      "One row for each condition, one column for each moment; all have one seed, "
                                      "one camera and one scale",
                                      "", Picture::Size::large));
      } catch (const UsageError&) {  // there is nothing that can be seen
        return;
      } catch (const NondeterminismError& error) { section.body.note(error.what()); }
    }
  }
  part.sections.insert(part.sections.begin(), std::move(section));
}

std::vector<Representative> representativesOf(const std::string& database) {
  const StudyComparison c = compareStudy(readStudyResults(database), {});
  const StudyResults& r = c.results;
  const std::vector<std::size_t> order = byDifference(c);
  std::vector<Representative> all;
  std::set<std::string> known;
  for (std::size_t s = 0; s < r.seeds.size(); ++s)
    for (const std::size_t k : order) {
      const std::size_t t = r.conditions[k].tasks.empty() ? noTask : r.conditions[k].tasks[s];
      if (t != noTask && r.tasks[t].status == TaskStatus::done && known.insert(r.tasks[t].runId).second)
        all.push_back({r.nameOf(r.conditions[k]), r.tasks[t].runId, r.seeds[s]});
    }
  return all;
}

std::vector<Finding> findingsOf(const StudyComparison& c, const std::string& database) {
  const StudyResults& r = c.results;
  std::vector<Finding> findings;
  judgeTasks(r, findings);
  judgeConditions(c, findings);
  judgeDivisions(r, database, findings);
  if (std::all_of(r.tasks.begin(), r.tasks.end(),
                  [](const ResultTask& t) { return t.status == TaskStatus::done && t.isSane; }))
    findings.push_back({Finding::Kind::good, "Every run is done and sane"});
  return findings;
}

}  // namespace morula
