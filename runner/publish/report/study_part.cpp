#include "report/study_part.h"

#include <map>
#include <set>

#include "analysis/comparison.h"
#include "analysis/differing.h"
#include "analysis/organisms.h"
#include "analysis/picture.h"
#include "database/store_error.h"
#include "files/read_file.h"
#include "loop/stored_scenario.h"
#include "store/store.h"
#include "system/installation.h"
#include "system/signals.h"
#include "system/usage_error.h"

namespace morula {
namespace {

constexpr std::size_t mostDrawn = 12;      // conditions of which a run is made again
constexpr std::size_t mostShown = 24;      // stored pictures
constexpr std::size_t mostSentences = 16;  // that are seen without being asked for

Database openStudy(const std::string& file) {
  return Database(file, Database::Mode::existing, std::chrono::milliseconds(30'000));
}

/// A chart a measure, each as wide as a telephone; what shapes and colours mean once.
Document stripsDocument(const StudyComparison& c) {
  SmallMultiples all = stripsOf(c);
  Document document, charts;
  document.note(all.words.caption);
  // Shapes as letters, so that colours are told apart in grey, too.
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
  for (const ResultTask& task : r.tasks) done += task.status == "done";
  PagePart part{.title = "Study " + r.name,
                .summary = r.summary,
                .verdict = verdict(std::to_string(done) + " of " + counted(r.tasks.size(), "distinct run") +
                                       (r.tasks.size() == 1 ? " is" : " are") +
                                       " done: " + counted(r.conditions.size(), "condition") + ", " +
                                       counted(r.seeds.size(), "seed") + ".",
                                   findingsOf(c, database))};
  const std::vector<std::string> sentences = verdictsOf(c);
  PlainList said, more;
  for (std::size_t i = 0; i < sentences.size(); ++i) (i < mostSentences ? said : more).list.push_back(sentences[i]);
  Document findings;
  if (said.list.empty()) findings.say("Nothing: no measure has values.");
  else findings.add(std::move(said));
  if (!more.list.empty()) {
    const std::string title = counted(more.list.size(), "more sentence");
    findings.add(folded(title, Document().add(std::move(more))));
  }
  const std::string file = shellWord(database);
  part.change.push_back(
      {"findings", "What the study finds", std::move(findings), {programWord() + " study compare " + file}});
  part.sections.push_back(
      {"strips", "Every value", stripsDocument(c), {programWord() + " study compare " + file + " -o strips.svg"}});
  Document body = comparedTables(c);
  Downloads downloads;
  for (Downloads::File file : {Downloads::File{"comparison.csv", "text/csv", toCsv(c)},
                               Downloads::File{"comparison.json", "application/json", jsonText(toJson(c), 1)}})
    if (file.bytes.size() <= 1'000'000) downloads.files.push_back(std::move(file));
  body.add(std::move(downloads));
  part.sections.push_back({"comparison",
                           "Comparison",
                           std::move(body),
                           {programWord() + " study compare " + file + " --csv > comparison.csv",
                            programWord() + " study compare " + file + " --json > comparison.json"}});
  return part;
}

namespace {

/// Of the first run that is done; false without any.
bool hasBodies(const StudyResults& results, const std::string& database) {
  for (const ResultTask& task : results.tasks)
    if (task.status == "done") return storedScenario(database, task.runId).scene.mechanics.has_value();
  return false;
}

}  // namespace

int addOrganisms(PagePart& part, const std::string& database, bool quiet) {
  const StudyResults results = readStudyResults(database);
  PageSection section{
      "organisms", "Organisms", {}, {programWord() + " compare " + shellWord(database) + " --pictures grid.png"}};
  if (const auto stored = storedPictures(results, database)) {
    Document pictures;
    std::vector<std::size_t> order = byDifference(compareStudy(results, {}));
    order.resize(std::min(mostShown, order.size()));
    for (const std::size_t k : order)
      pictures.add(Picture{"image/png", readFile(stored->files[k]),
                           "the organism at the end of " + results.nameOf(results.conditions[k]),
                           results.nameOf(results.conditions[k])});
    section.body.note("At the end, with seed " + std::to_string(results.seeds[stored->seed]) +
                      ": the pictures that the study keeps in " + stored->files[0].parent_path().generic_string() +
                      (stored->files.size() > mostShown ? "; the first " + std::to_string(mostShown) + " of " +
                                                              counted(stored->files.size(), "condition")
                                                        : "") +
                      ". Each has a scale bar of its own.");
    section.body.add(Group{Group::Kind::charts, "", std::move(pictures)});
  } else {
    if (!whyTooMany(results, {}).empty() || !hasBodies(results, database)) return 0;
    if (results.conditions.size() > mostDrawn) {
      section.body.note(counted(results.conditions.size(), "condition") +
                        " are too many to be run again for this page; the command draws them.");
    } else {
      try {
        for (const Drawing& page : drawOrganisms(results, database, {}, quiet))
          section.body.add(pngPicture(page.pixels(), "the organisms of all conditions at five moments",
                                      "A row a condition, a column a moment; one seed, one camera, one scale", "",
                                      Picture::Size::large));
      } catch (const Interrupted& by) {
        return by.signal;
      } catch (const UsageError&) {  // there is nothing that can be seen
        return 0;
      } catch (const NondeterminismError& error) { section.body.note(error.what()); }
    }
  }
  part.sections.insert(part.sections.begin(), std::move(section));
  return 0;
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
      if (t != noTask && r.tasks[t].status == "done" && known.insert(r.tasks[t].runId).second)
        all.push_back({r.nameOf(r.conditions[k]), r.tasks[t].runId, r.seeds[s]});
    }
  return all;
}

}  // namespace morula
