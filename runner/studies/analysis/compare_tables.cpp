#include "analysis/compare_tables.h"

#include <fmt/format.h>

#include "analysis/measure_words.h"
#include "base/number_text.h"
#include "files/text.h"

namespace morula {
namespace {

Cell bound(const std::optional<Interval>& i, double Interval::*end, int digits = 4) {
  return number(i ? std::optional((*i).*end) : std::nullopt, digits);
}

/// Returns the shape of a sample; people read only what is not plain.
Cell shapeCell(SampleShape shape) { return Cell(nameOf(shape), shape == SampleShape::plain ? "" : nameOf(shape)); }

/// Returns "0.42 to 0.44".
Words rangeOf(const std::optional<Interval>& i) {
  return i ? numberText(i->low, 4) + " to " + numberText(i->high, 4) : std::string();
}

std::string fixedOf(const StudyComparison& c, const PairComparison& pair) {
  std::vector<std::string> fixed;
  for (std::size_t a = 0; a < pair.at.size(); ++a)
    if (pair.at[a]) fixed.push_back(c.results.axes[a].labels[*pair.at[a]]);
  return fixed.empty() ? "in the mean" : join(fixed);
}

Json fixedJson(const StudyComparison& c, const PairComparison& pair) {
  Json at = Json::object();
  for (std::size_t a = 0; a < pair.at.size(); ++a)
    if (pair.at[a]) at[c.results.axes[a].name] = c.results.axes[a].labels[*pair.at[a]];
  return at;
}

/// Declares the columns of a row's measure and condition.
template <class Row>
std::vector<FieldOf<Row>> ofCondition(const StudyComparison& c) {
  const StudyResults& r = c.results;
  std::vector<FieldOf<Row>> fields{
      {{"measure", "measure", ""}, [&](const Row& row) { return c.measureName(row.measure); }},
      {{"", "unit", ""}, [&](const Row& row) { return unitOfMeasure(c.measureName(row.measure)); }},
      {{"labels", "", ""}, [&](const Row& row) { return exact(labelsOf(r, r.conditions[row.condition].levels)); }}};
  for (std::size_t a = 0; a < r.axes.size(); ++a)
    fields.push_back({{"", "axis:" + r.axes[a].name, r.axes[a].name},
                      [&r, a](const Row& row) { return r.axes[a].labels[r.conditions[row.condition].levels[a]]; }});
  return fields;
}

template <class Row>
std::vector<FieldOf<Row>> operator+(std::vector<FieldOf<Row>> fields, const std::vector<FieldOf<Row>>& more) {
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

}  // namespace

Json labelsOf(const StudyResults& r, const std::vector<std::size_t>& levels) {
  Json labels = Json::object();
  for (std::size_t a = 0; a < r.axes.size(); ++a) labels[r.axes[a].name] = r.axes[a].labels[levels[a]];
  return labels;
}

Table valueTable(const StudyComparison& c) {
  std::vector<SeedValue> values;
  for (const ConditionSummary& s : c.conditions)
    for (std::size_t i = 0; i < s.values.size(); ++i)
      values.push_back({s.measure, s.condition, s.seeds[i], s.values[i]});
  using Row = SeedValue;
  const std::vector<FieldOf<Row>> fields{
      {{"", "seed", "seed"}, [](const Row& v) { return v.seed; }},
      {{"", "value", "value"}, [](const Row& v) { return number(v.value); }},
  };
  return tableOf("Values", ofCondition<Row>(c) + fields, values);
}

Table conditionTable(const StudyComparison& c, const std::vector<ConditionSummary>& of) {
  using Row = ConditionSummary;
  const std::vector<FieldOf<Row>> fields{
      {{"n", "n", "n"}, [](const Row& s) { return s.values.size(); }},
      {{"distinct", "distinct", "distinct"}, [](const Row& s) { return s.distinct; }},
      {{"mean", "value", "mean"}, [](const Row& s) { return s.values.empty() ? exact({}) : number(s.mean); }},
      {{"low", "low", ""}, [](const Row& s) { return bound(s.interval, &Interval::low); }},
      {{"high", "high", ""}, [](const Row& s) { return bound(s.interval, &Interval::high); }},
      {{"", "", "95 % interval"}, [](const Row& s) { return Cell({}, s.onePath ? "one path" : rangeOf(s.interval)); }},
      {{"shape", "shape", "shape"}, [](const Row& s) { return shapeCell(s.shape); }},
      {{"one_path", "", ""}, [](const Row& s) { return exact(s.onePath); }},
      {{"seeds", "", ""}, [](const Row& s) { return exact(s.seeds); }},
      {{"values", "", "values"},
       [](const Row& s) {
         std::string values;
         for (const double v : s.values) values += (values.empty() ? "" : " ") + numberText(v, 4);
         return Cell(s.values, values);
       }},
  };
  return tableOf("Conditions", ofCondition<Row>(c) + fields, of);
}

Table pairTable(const StudyComparison& c, const std::vector<PairComparison>& of) {
  using Row = PairComparison;
  const auto axisOf = [&](const Row& p) -> const ResultAxis& { return c.results.axes[p.axis]; };
  const auto ifEstimated = [](const Row& p, double value, int digits = 4) {
    return p.known == Known::estimated ? number(value, digits) : exact({});
  };
  std::vector<FieldOf<Row>> fields{
      {{"measure", "measure", ""}, [&](const Row& p) { return c.measureName(p.measure); }},
      {{"", "unit", ""}, [&](const Row& p) { return unitOfMeasure(c.measureName(p.measure)); }},
      {{"axis", "by", ""}, [&](const Row& p) { return axisOf(p).name; }},
      {{"a", "a", ""}, [&](const Row& p) { return axisOf(p).labels[p.a]; }},
      {{"b", "b", ""}, [&](const Row& p) { return axisOf(p).labels[p.b]; }},
      {{"", "", "a − b"}, [&](const Row& p) { return axisOf(p).labels[p.a] + " − " + axisOf(p).labels[p.b]; }},
      {{"at", "", "of the others"}, [&](const Row& p) { return Cell(fixedJson(c, p), fixedOf(c, p)); }},
      {{"n", "n", "pairs"}, [](const Row& p) { return p.of.size(); }},
      {{"known", "", ""}, [](const Row& p) { return nameOf(p.known); }},
      {{"same_runs", "", ""}, [](const Row& p) { return exact(p.sameRuns); }},
      {{"mean_a", "", ""}, [](const Row& p) { return number(p.meanA); }},
      {{"mean_b", "", ""}, [](const Row& p) { return number(p.meanB); }},
      {{"difference", "value", "difference"}, [](const Row& p) { return number(p.paired.difference); }},
      {{"low", "low", ""}, [](const Row& p) { return bound(p.paired.interval, &Interval::low); }},
      {{"high", "high", ""}, [](const Row& p) { return bound(p.paired.interval, &Interval::high); }},
      {{"", "", "95 % interval"},
       [](const Row& p) {
         const bool isNamed = p.known == Known::exact || p.known == Known::onePath;
         return Cell({}, isNamed ? nameOf(p.known) : rangeOf(p.paired.interval));
       }},
      {{"shape", "shape", "shape"}, [](const Row& p) { return shapeCell(p.paired.sample.shape); }},
      {{"p", "p", "p"}, [=](const Row& p) { return ifEstimated(p, p.paired.p, 2); }},
      {{"p_holm", "p_holm", "Holm"}, [](const Row& p) { return number(p.corrected, 2); }},
      {{"effect", "effect", "d" + Words("z", Emphasis::subscript)},
       [](const Row& p) { return number(p.effect.dz, 3); }},
      {{"d", "", ""}, [](const Row& p) { return number(p.effect.d); }},
      {{"g", "g", "g"}, [](const Row& p) { return number(p.effect.g, 3); }},
      {{"higher", "higher", "higher"}, [](const Row& p) { return p.signs.higher; }},
      {{"lower", "lower", "lower"}, [](const Row& p) { return p.signs.lower; }},
      {{"same", "", ""}, [](const Row& p) { return p.signs.same; }},
      {{"unpaired", "", "unpaired"},
       [](const Row& p) {
         if (!p.unpaired) return exact({});
         const MeanDifference& u = *p.unpaired;
         return Cell(Json{{"low", bound(u.interval, &Interval::low).value},
                          {"high", bound(u.interval, &Interval::high).value},
                          {"p", u.p}},
                     rangeOf(u.interval));
       }},
      {{"", "unpaired_low", ""},
       [](const Row& p) { return bound(p.unpaired ? p.unpaired->interval : std::nullopt, &Interval::low); }},
      {{"", "unpaired_high", ""},
       [](const Row& p) { return bound(p.unpaired ? p.unpaired->interval : std::nullopt, &Interval::high); }},
      {{"interval_ratio", "interval_ratio", "paired/unpaired"},
       [](const Row& p) { return number(p.intervalRatio(), 2); }},
      {{"", "margin", ""}, [](const Row& p) { return p.equivalence ? number(p.equivalence->test.margin) : exact({}); }},
      {{"", "p_equivalent_holm", ""},
       [](const Row& p) { return p.equivalence ? number(p.equivalence->corrected) : exact({}); }},
      {{"", "equivalent", ""}, [](const Row& p) { return p.equivalence ? nameOf(p.equivalence->verdict) : exact({}); }},
  };
  if (!c.margins.empty())
    fields.push_back({{"equivalence", "", ""}, [&](const Row& p) {
                        return exact(p.equivalence ? jsonOf(equivalenceTable(c, {p}))[0] : Json());
                      }});
  return tableOf("Paired differences", fields, of);
}

Table equivalenceTable(const StudyComparison& c, const std::vector<PairComparison>& of) {
  std::vector<PairComparison> tested;
  for (const PairComparison& p : of)
    if (p.equivalence) tested.push_back(p);
  using Row = PairComparison;
  const std::vector<FieldOf<Row>> fields{
      {{"", "", "a, b"},
       [&](const Row& p) { return c.results.axes[p.axis].labels[p.a] + ", " + c.results.axes[p.axis].labels[p.b]; }},
      {{"", "", "of the others"}, [&](const Row& p) { return fixedOf(c, p); }},
      {{"", "", "difference"}, [](const Row& p) { return number(p.paired.difference); }},
      {{"low", "", ""}, [](const Row& p) { return bound(p.equivalence->test.interval, &Interval::low); }},
      {{"high", "", ""}, [](const Row& p) { return bound(p.equivalence->test.interval, &Interval::high); }},
      {{"", "", "90 % interval"}, [](const Row& p) { return rangeOf(p.equivalence->test.interval); }},
      {{"margin", "", "margin"},
       [](const Row& p) { return Cell(p.equivalence->test.margin, "±" + numberText(p.equivalence->test.margin, 4)); }},
      {{"p", "", "p"}, [](const Row& p) { return number(p.equivalence->test.p, 2); }},
      {{"p_holm", "", "Holm"}, [](const Row& p) { return number(p.equivalence->corrected, 2); }},
      {{"p_beyond", "", ""}, [](const Row& p) { return number(p.equivalence->test.pBeyond); }},
      {{"p_beyond_holm", "", ""}, [](const Row& p) { return number(p.equivalence->correctedBeyond); }},
      {{"verdict", "", "verdict"}, [](const Row& p) { return nameOf(p.equivalence->verdict); }},
  };
  return tableOf("Equivalence", fields, tested);
}

Table effectTable(const StudyComparison& c, const MeasureEffects& of) {
  using Row = FactorEffect;
  const auto axis = [&](std::size_t factor) -> const ResultAxis& { return c.results.axes[of.axes[factor]]; };
  const auto axesOf = [=](const Row& e) {
    std::vector<std::string> names;
    for (const std::size_t f : e.factors) names.push_back(axis(f).name);
    return names;
  };
  const auto corrected = [&](const Row& e) {
    return of.corrected[static_cast<std::size_t>(&e - of.analysis.effects.data())];
  };
  const std::vector<FieldOf<Row>> fields{
      {{"axes", "", "effect of"}, [=](const Row& e) { return Cell(axesOf(e), join(axesOf(e), " × ")); }},
      {{"", "measure", ""}, [&](const Row&) { return c.measureName(of.measure); }},
      {{"", "by", ""}, [=](const Row& e) { return join(axesOf(e), " x "); }},
      {{"eta_squared", "value", "η²"}, [](const Row& e) { return number(e.share, 3); }},
      {{"partial_eta_squared", "", "partial"}, [](const Row& e) { return number(e.partial, 3); }},
      {{"partial_low", "", "95 %"}, [](const Row& e) { return bound(e.partialInterval, &Interval::low, 2); }},
      {{"partial_high", "", "interval"}, [](const Row& e) { return bound(e.partialInterval, &Interval::high, 2); }},
      {{"f", "effect", "F"}, [](const Row& e) { return number(e.f, 3); }},
      {{"df", "", "df"},
       [](const Row& e) {
         const double d = e.degreesOfFreedom, error = e.errorDegreesOfFreedom;
         return Cell(d, e.f ? fmt::format("{}, {}", d, error) : "-");
       }},
      {{"error_df", "", ""}, [](const Row& e) { return number(e.errorDegreesOfFreedom); }},
      {{"epsilon", "", "ε"}, [](const Row& e) { return number(e.f ? std::optional(e.epsilon) : std::nullopt, 3); }},
      {{"p", "p", "p"}, [](const Row& e) { return number(e.p, 2); }},
      {{"p_holm", "p_holm", "Holm"}, [=](const Row& e) { return number(corrected(e), 2); }},
      {{"means", "", "means"},
       [=, &of](const Row& e) {
         if (e.factors.size() != 1) return Cell({}, " ");
         Cell means(Json::object(), "");
         const auto& labels = axis(e.factors[0]).labels;
         for (std::size_t l = 0; l < labels.size(); ++l) {
           const double mean = of.means[e.factors[0]][l];
           means.value[labels[l]] = mean;
           means.words += (l ? ", " : "") + labels[l] + " " + numberText(mean, 4);
         }
         return means;
       }},
      {{"", "n", ""}, [&](const Row&) { return of.seeds; }},
  };
  return tableOf("Main effects and interactions", fields, of.analysis.effects);
}

Table courseTable(const StudyComparison& c, const TimeCourse& of) {
  using Row = TimeCourse::Point;
  std::vector<FieldOf<Row>> fields{
      {{"", "measure", ""}, [&](const Row&) { return c.measureName(of.measure); }},
      {{"", "unit", ""}, [&](const Row&) { return unitOfMeasure(c.measureName(of.measure)); }}};
  for (std::size_t a = 0; a < c.results.axes.size(); ++a)
    fields.push_back({{"", "axis:" + c.results.axes[a].name, ""}, [&, a](const Row&) {
                        return c.results.axes[a].labels[c.results.conditions[of.condition].levels[a]];
                      }});
  const std::vector<FieldOf<Row>> ofPoint{
      {{"time", "time", "time"}, [](const Row& p) { return number(p.time); }},
      {{"n", "n", "n"}, [](const Row& p) { return p.n; }},
      {{"mean", "value", "mean"}, [](const Row& p) { return number(p.mean); }},
      {{"low", "low", ""}, [](const Row& p) { return bound(p.interval, &Interval::low); }},
      {{"high", "high", ""}, [](const Row& p) { return bound(p.interval, &Interval::high); }},
  };
  return tableOf("Means over time", std::move(fields) + ofPoint, of.points);
}

}  // namespace morula
