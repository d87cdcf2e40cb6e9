// A comparison as a document, and its tables for other programs.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/compare_parts.h"
#include "analysis/compare_tables.h"
#include "analysis/measure_words.h"
#include "base/number_text.h"

namespace morula {
namespace {

constexpr std::size_t maxTroubles = 20;  // max that are listed
constexpr std::size_t maxTimes = 8;      // max in a table of means over time

template <class Row>
std::vector<Row> ofMeasure(const std::vector<Row>& rows, std::size_t measure) {
  std::vector<Row> some;
  std::ranges::copy_if(rows, std::back_inserter(some), [&](const Row& row) { return row.measure == measure; });
  return some;
}

std::vector<PairComparison> ofAxis(std::vector<PairComparison> pairs, std::size_t axis) {
  std::erase_if(pairs, [&](const PairComparison& pair) { return pair.axis != axis; });
  return pairs;
}

/// Returns "thread, own: 10 runs that are one run".
std::string onePathText(const StudyResults& r, std::size_t condition) {
  std::set<std::size_t> runs;
  for (const std::size_t t : r.conditions[condition].tasks)
    if (r.isDone(t)) runs.insert(t);
  return fmt::format("{}: {} runs that are one run", r.nameOf(r.conditions[condition]), runs.size());
}

Document header(const StudyComparison& c) {
  const StudyResults& r = c.results;
  const auto done = std::ranges::count(r.tasks, TaskStatus::done, &ResultTask::status);
  Document text;
  text.say(fmt::format("{}: {} conditions, {}, {} of {} distinct runs done", r.name, r.conditions.size(),
                       counted(r.seeds.size(), "seed"), done, r.tasks.size()));
  if (!r.summary.empty()) text.say(r.summary);
  auto troubles = troublesOf(r);
  if (const std::size_t all = troubles.size(); all > maxTroubles) {
    troubles.resize(maxTroubles);
    troubles.push_back(fmt::format("… and {} more; --json lists them all", all - maxTroubles));
  }
  if (!troubles.empty()) text.add(PlainList{{troubles.begin(), troubles.end()}});
  PlainList seedless;
  for (const std::size_t i : c.seedless) seedless.list.push_back(r.nameOf(r.conditions[i]));
  if (!seedless.list.empty())
    text.say("conditions that seeds do not change have one run and no interval").add(std::move(seedless));
  PlainList onePaths;
  for (const std::size_t i : c.onePaths) onePaths.list.push_back(onePathText(r, i));
  if (!onePaths.list.empty())
    text.say("one path: the runs of these conditions differ by less than a millionth, so they have no interval")
        .add(std::move(onePaths));
  return text;
}

/// Makes a table with a row for each condition, and at most eight of the times.
Table meansOverTime(const StudyComparison& c, const std::vector<TimeCourse>& courses) {
  Table table{"Means over time", {timeLabel(c.units)}};
  for (const TimeCourse& course : courses) {
    const std::size_t count = course.points.size(), columns = std::min(count, maxTimes);
    std::vector<Cell> row{c.results.nameOf(c.results.conditions[course.condition])};
    for (std::size_t i = 0; i < columns; ++i) {
      const auto& point = course.points[columns < 2 ? 0 : i * (count - 1) / (columns - 1)];
      row.push_back(number(point.mean));
      if (table.rows.empty()) table.columns.push_back(numberText(point.time, 4));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json unfinished(const StudyResults& r) {
  Json list = Json::array();
  for (const ResultCondition& condition : r.conditions)
    for (std::size_t s = 0; s < r.seeds.size(); ++s) {
      const std::size_t t = condition.tasks[s];
      if (t == noTask || r.isDone(t)) continue;
      list.push_back({{"labels", labelsOf(r, condition.levels)},
                      {"seed", r.seeds[s]},
                      {"task", r.tasks[t].id},
                      {"status", nameOf(r.tasks[t].status)},
                      {"reason", r.tasks[t].reason}});
    }
  return list;
}

}  // namespace

Document describe(const StudyComparison& c) {
  Document text = header(c);
  if (const auto verdicts = verdictsOf(c); !verdicts.empty())
    text.heading("Findings of the study").add(PlainList{{verdicts.begin(), verdicts.end()}});
  if (const std::string units = unitsInWords(c); !units.empty()) text.say(units);
  text.add(interactionTables(c));
  text.heading("Measures").add(measureTable(c));
  return text.add(comparedTables(c));
}

Table measureTable(const StudyComparison& c) {
  const std::vector<FieldOf<std::string>> fields{
      {{"measure", "", "measure"}, [](const std::string& m) { return m; }},
      {{"name", "", "name"}, [](const std::string& m) { return wordsOfMeasure(m).noun; }},
      {{"unit", "", ""}, [](const std::string& m) { return unitOfMeasure(m); }},
      {{"", "", "unit"}, [&](const std::string& m) { return shownUnit(c.units, unitOfMeasure(m)).name; }},
      {{"meaning", "", "meaning"}, [](const std::string& m) { return meaningOfMeasure(m); }}};
  std::vector<std::string> names;
  for (const std::size_t m : c.measures) names.push_back(c.measureName(m));
  return tableOf("Measures", fields, names);
}

Document comparedTables(const StudyComparison& c) {
  Document text;
  const auto add = [&](const std::string& heading, Table table) {
    if (!table.rows.empty()) text.heading(heading).add(std::move(table));
  };
  for (const std::size_t m : c.measures) {
    const auto conditions = ofMeasure(c.conditions, m);
    if (std::ranges::all_of(conditions, [](const ConditionSummary& s) { return s.values.empty(); })) continue;
    const std::string name = c.measureName(m), unit = shownUnit(c.units, unitOfMeasure(name)).name;
    add(name + (unit.empty() ? "" : " [" + unit + "]"), conditionTable(c, conditions));
    const auto pairs = ofMeasure(c.pairs, m);
    const auto by = [&](std::size_t axis) { return name + " by " + c.results.axes[axis].name; };
    for (const std::size_t axis : c.by) add(by(axis) + ", seed by seed", pairTable(c, ofAxis(pairs, axis)));
    for (const std::size_t axis : c.by)
      if (const auto interaction = interactionOf(c, m, axis))
        add(by(axis) + " at each level of " + c.results.axes[interaction->other].name,
            pairTable(c, ofAxis(ofMeasure(c.split, m), axis)));
    add(name + ": equivalence, two one-sided tests", equivalenceTable(c, pairs));
    for (const MeasureEffects& e : ofMeasure(c.effects, m)) {
      add(name + ": main effects and interactions", effectTable(c, e));
      if (!e.untested.empty()) text.note("no F test: " + e.untested);
    }
    add(name + ": means over time", meansOverTime(c, ofMeasure(c.courses, m)));
  }
  return text;
}

Json toJson(const StudyComparison& c, const Units& known) {
  const StudyResults& r = c.results;
  Json by = Json::array(), seedless = Json::array(), onePaths = Json::array(), effects = Json::array(),
       courses = Json::array();
  for (const std::size_t a : c.by) by.push_back(r.axes[a].name);
  for (const std::size_t i : c.seedless) seedless.push_back(labelsOf(r, r.conditions[i].levels));
  for (const std::size_t i : c.onePaths) onePaths.push_back(labelsOf(r, r.conditions[i].levels));
  for (const MeasureEffects& e : c.effects)
    effects.push_back({{"measure", c.measureName(e.measure)},
                       {"seeds", e.seeds},
                       {"untested", e.untested.empty() ? Json() : Json(e.untested)},
                       {"effects", jsonOf(effectTable(c, e))}});
  for (const TimeCourse& course : c.courses)
    courses.push_back({{"measure", c.measureName(course.measure)},
                       {"labels", labelsOf(r, r.conditions[course.condition].levels)},
                       {"points", jsonOf(courseTable(c, course))}});
  return {{"study", r.name},
          {"by", by},
          {"units", unitsJson(c, known)},
          {"troubles", troublesOf(r)},
          {"unfinished", unfinished(r)},
          {"seeds_change_nothing", seedless},
          {"one_path", onePaths},
          {"verdicts", verdictsOf(c)},
          {"interactions", interactionsJson(c)},
          {"measures", jsonOf(measureTable(c))},
          {"conditions", jsonOf(conditionTable(c, c.conditions))},
          {"pairs", jsonOf(pairTable(c, c.pairs))},
          {"split", jsonOf(pairTable(c, c.split))},
          {"effects", effects},
          {"courses", courses}};
}

std::string toCsv(const StudyComparison& c) {
  std::vector<std::pair<std::string, Table>> kinds{{"value", valueTable(c)},
                                                   {"condition", conditionTable(c, c.conditions)},
                                                   {"pair", pairTable(c, c.pairs)},
                                                   {"split", pairTable(c, c.split)}};
  for (const MeasureEffects& e : c.effects) kinds.emplace_back("effect", effectTable(c, e));
  for (const TimeCourse& course : c.courses) kinds.emplace_back("course", courseTable(c, course));
  std::vector<std::string> names{"kind", "measure"};
  for (const ResultAxis& axis : c.results.axes) names.push_back("axis:" + axis.name);
  for (const char* name : {"by", "a", "b", "seed", "time", "n", "distinct"})
    names.push_back(name);  // the others follow
  return csvOf(stacked(kinds, names), "\n");
}

}  // namespace morula
