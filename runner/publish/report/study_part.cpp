#include "report/study_part.h"

#include <set>

#include "analysis/comparison.h"
#include "analysis/measure_words.h"
#include "analysis/organisms.h"
#include "analysis/picture.h"
#include "base/number_text.h"
#include "database/store_error.h"
#include "loop/stored_scenario.h"
#include "page/html.h"
#include "store/store.h"
#include "system/signals.h"
#include "system/usage_error.h"

namespace morula {

namespace {

constexpr std::size_t mostDrawn = 12;      // conditions of which a run is made again
constexpr std::size_t mostSentences = 16;  // that are seen without being asked for

Database openStudy(const std::string& file) {
  return Database(file, Database::Mode::existing, std::chrono::milliseconds(30'000));
}

std::string withInterval(double mean, const std::optional<Interval>& interval) {
  return numberText(mean) + (interval ? " <span class=\"note\">[" + numberText(interval->low) + ", " +
                                            numberText(interval->high) + "]</span>"
                                      : "");
}

std::string conditionTable(const StudyComparison& c) {
  std::vector<std::string> head{"Condition"};
  for (const std::size_t m : c.measures) { head.push_back(shown(titleOfMeasure(c.measureName(m)))); }
  head.push_back("Values");
  head.push_back("Distinct");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t k = 0; k < c.results.conditions.size(); ++k) {
    std::vector<std::string> row{shown(c.results.nameOf(c.results.conditions[k]))};
    std::string values, distinct;
    for (const std::size_t m : c.measures) {
      std::string cell = "none";
      for (const ConditionSummary& s : c.conditions)
        if (s.measure == m && s.condition == k && !s.values.empty())
          cell = withInterval(s.mean, s.interval), values = std::to_string(s.values.size()),
          distinct = std::to_string(s.distinct);
      row.push_back(cell);
    }
    row.push_back(values);
    row.push_back(distinct);
    rows.push_back(std::move(row));
  }
  return htmlTable("Means and their 95 % intervals", head, rows);
}

std::string pairTable(const StudyComparison& c) {
  std::vector<std::vector<std::string>> rows;
  for (const PairComparison& p : c.pairs) {
    const auto& labels = c.results.axes[p.axis].labels;
    std::string fixed;
    for (std::size_t axis = 0; axis < p.at.size(); ++axis)
      if (p.at[axis]) fixed += (fixed.empty() ? " at " : ", ") + c.results.axes[axis].labels[*p.at[axis]];
    const bool estimated = p.known == Known::estimated;
    rows.push_back(
        {shown(titleOfMeasure(c.measureName(p.measure))), shown(labels[p.a] + " − " + labels[p.b] + fixed),
         std::to_string(p.of.size()),
         estimated ? withInterval(p.paired.difference, p.paired.interval) : numberText(p.meanA - p.meanB),
         estimated                 ? numberText(p.corrected, 3)
         : p.known == Known::exact ? "exact"
                                   : "one seed",
         estimated && p.effect.dz ? numberText(*p.effect.dz, 3) : "", p.isShown() ? "<b>differs</b>" : ""});
  }
  if (rows.empty()) return {};
  return "<h3>Differences, seed by seed</h3>\n" +
         htmlTable("Paired differences",
                   {"Measure", "Levels", "Pairs", "Difference", "p (Holm)", "Effect d<sub>z</sub>", ""},
                   rows);
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
  PagePart part{.title = "Study " + r.name, .summary = r.summary, .verdict = {}, .change = {}, .blocks = {}};
  part.verdict = "<p class=\"said\">" + std::to_string(done) + " of " +
                 counted(r.tasks.size(), "distinct run") + (r.tasks.size() == 1 ? " is" : " are") +
                 " done: " + counted(r.conditions.size(), "condition") + ", " +
                 counted(r.seeds.size(), "seed") + ".</p>\n" + findingsHtml(findingsOf(c, database));
  const std::vector<std::string> sentences = verdictsOf(c);
  std::string said, more;
  for (std::size_t i = 0; i < sentences.size(); ++i)
    (i < mostSentences ? said : more) += "<li>" + shown(sentences[i]) + "</li>\n";
  if (!said.empty()) said = "<ul>\n" + said + "</ul>\n";
  if (!more.empty())
    said +=
        htmlFolded(counted(sentences.size() - mostSentences, "more sentence"), "<ul>\n" + more + "</ul>\n");
  const std::string file = shellWord(database);
  part.change.push_back({"findings",
                         "What the study finds",
                         said.empty() ? "<p>Nothing: no measure has values.</p>\n" : said,
                         {"./morula study compare " + file}});
  part.blocks.push_back(
      {"strips",
       "Every value",
       htmlLarge("image/svg+xml", drawComparedStudy(c).file(PictureFormat::svg),
                 "strips of all values of each condition, with their means and 95 % intervals",
                 "A dot a run; line and bar: the mean and its 95 % interval"),
       {"./morula study compare " + file + " -o strips.svg"}});
  const auto csv = toCsv(c), json = jsonText(toJson(c), 1);
  const auto link = [&](const std::string& name, const char* type, const std::string& bytes) {
    return bytes.size() > 1'000'000
               ? ""
               : "<a download=\"" + name + "\" href=\"" + dataUri(type, bytes) + "\">" + name +
                     " <span class=\"note\">(" + inBytes(bytes.size()) + ")</span></a>\n";
  };
  part.blocks.push_back({"comparison",
                         "Comparison",
                         conditionTable(c) + pairTable(c) +
                             htmlFolded("All of it, as text", shownBlock(describe(c))) +
                             "<div class=\"downloads\">" + link("comparison.csv", "text/csv", csv) +
                             link("comparison.json", "application/json", json) + "</div>\n",
                         {"./morula study compare " + file + " --csv > comparison.csv",
                          "./morula study compare " + file + " --json > comparison.json"}});
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
  PageBlock block{
      "organisms", "Organisms", "", {"./morula compare " + shellWord(database) + " --pictures grid.png"}};
  if (!whyTooMany(results, {}).empty() || !hasBodies(results, database)) return 0;
  if (results.conditions.size() > mostDrawn) {
    block.html = "<p class=\"note\">" + counted(results.conditions.size(), "condition") +
                 " are too many to be run again for this page; the command draws them.</p>\n";
  } else {
    try {
      block.html = htmlLarge("image/png", pngFile(drawOrganisms(results, database, {}, quiet).pixels()),
                             "the organisms of all conditions at five moments",
                             "A row a condition, a column a moment; one seed, one camera, one scale");
    } catch (const Interrupted& by) {
      return by.signal;
    } catch (const UsageError&) {  // there is nothing that can be seen
      return 0;
    } catch (const NondeterminismError& error) {
      block.html = "<p class=\"note\">" + shown(error.what()) + "</p>\n";
    }
  }
  part.blocks.insert(part.blocks.begin(), std::move(block));
  return 0;
}

std::vector<Representative> representativesOf(const std::string& database, std::size_t most) {
  const StudyResults r = readStudyResults(database);
  Database db = openStudy(database);
  Statement find(db, "SELECT run_id FROM task WHERE task_id = ? AND run_id IS NOT NULL");
  std::vector<Representative> all;
  std::set<std::string> known;
  for (const ResultCondition& condition : r.conditions) {
    for (const std::size_t t : condition.tasks) {
      if (all.size() >= most) return all;
      if (t == noTask || r.tasks[t].status != "done") continue;
      std::string run;
      find.start(r.tasks[t].id);
      while (find.next()) run = find.line(0);
      if (run.empty() || !known.insert(run).second) continue;
      all.push_back({r.nameOf(condition), run});
      break;
    }
  }
  return all;
}

}  // namespace morula
