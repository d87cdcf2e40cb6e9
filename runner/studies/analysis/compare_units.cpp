// The numbers of a comparison in the units that people know.
#include "analysis/measure_words.h"
#include "analysis/study_comparison.h"
#include "values/measure_list.h"

namespace morula {
namespace {

void scale(std::optional<Interval>& interval, double factor) {
  if (interval) interval->low *= factor, interval->high *= factor;
}

void scale(MeanDifference& d, double factor) {
  d.difference *= factor, d.standardError *= factor;
  scale(d.interval, factor);
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values) value *= factor;
}

void scale(PairComparison& p, double factor) {
  scale(p.of, factor), scale(p.against, factor), scale(p.paired, factor);
  p.meanA *= factor, p.meanB *= factor;
  if (p.unpaired) scale(*p.unpaired, factor);
  if (!p.equivalence) return;
  p.equivalence->test.margin *= factor;
  scale(p.equivalence->test.interval, factor);
}

}  // namespace

StudyComparison inUnits(StudyComparison c, const Units& units) {
  const auto factorOf = [&](const auto& row) {
    return shownUnit(units, unitOfMeasure(c.measureName(row.measure))).factor;
  };
  for (ConditionSummary& s : c.conditions) {
    scale(s.values, factorOf(s)), scale(s.interval, factorOf(s));
    s.mean *= factorOf(s);
  }
  for (auto* pairs : {&c.pairs, &c.split})
    for (PairComparison& pair : *pairs) scale(pair, factorOf(pair));
  for (MeasureEffects& e : c.effects)
    for (auto& means : e.means) scale(means, factorOf(e));
  for (TimeCourse& course : c.courses)
    for (TimeCourse::Point& point : course.points) {
      point.time *= shownUnit(units, "time").factor, point.mean *= factorOf(course);
      scale(point.interval, factorOf(course));
    }
  c.units = units;
  return c;
}

std::string unitsInWords(const StudyComparison& c) {
  std::string words = c.units.length;
  if (!c.units.time.empty()) words += (words.empty() ? "" : " and ") + c.units.time;
  return words.empty() ? ""
                       : "Numbers with lengths or times in them are in " + words + "; the tables' headings name units.";
}

Json unitsJson(const StudyComparison& c, const Units& known) {
  Json json = Json::object();
  for (const std::size_t m : c.measures) json[c.measureName(m)] = unitJson(known, unitOfMeasure(c.measureName(m)));
  json["time"] = unitJson(known, "time");
  return json;
}

}  // namespace morula
