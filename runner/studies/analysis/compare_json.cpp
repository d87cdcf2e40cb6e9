#include "analysis/comparison.h"

namespace morula {

namespace {

Json labelsOf(const StudyResults& r, const std::vector<std::size_t>& levels) {
  Json labels = Json::object();
  for (std::size_t a = 0; a < r.axes.size(); ++a) labels[r.axes[a].name] = r.axes[a].labels[levels[a]];
  return labels;
}

void put(Json& json, const std::optional<Interval>& interval) {
  json["low"] = interval ? Json(interval->low) : Json();
  json["high"] = interval ? Json(interval->high) : Json();
}

Json asJson(const StudyComparison& c, const ConditionSummary& s) {
  Json json{{"measure", c.measureName(s.measure)},
            {"labels", labelsOf(c.results, c.results.conditions[s.condition].levels)},
            {"n", s.values.size()},
            {"distinct", s.distinct},
            {"mean", s.values.empty() ? Json() : Json(s.mean)}};
  put(json, s.interval);
  json["seeds"] = s.seeds;
  json["values"] = s.values;
  return json;
}

const char* name(Known known) {
  constexpr const char* names[] = {"estimated", "exact", "one seed"};
  return names[static_cast<int>(known)];
}

Json asJson(const StudyComparison& c, const PairComparison& p) {
  const ResultAxis& axis = c.results.axes[p.axis];
  Json at = Json::object();
  for (std::size_t a = 0; a < p.at.size(); ++a)
    if (p.at[a]) at[c.results.axes[a].name] = c.results.axes[a].labels[*p.at[a]];
  const bool estimated = p.known == Known::estimated;
  const auto ifEstimated = [&](double value) { return estimated ? Json(value) : Json(); };
  Json json{{"measure", c.measureName(p.measure)},
            {"axis", axis.name},
            {"a", axis.labels[p.a]},
            {"b", axis.labels[p.b]},
            {"at", at},
            {"n", p.of.size()},
            {"known", name(p.known)},
            {"same_runs", p.sameRuns},
            {"mean_a", p.meanA},
            {"mean_b", p.meanB},
            {"difference", p.paired.difference},
            {"low", ifEstimated(p.paired.interval.low)},
            {"high", ifEstimated(p.paired.interval.high)},
            {"p", ifEstimated(p.paired.p)},
            {"p_holm", estimated && !p.sameRuns ? Json(p.corrected) : Json()},
            {"effect", orNull(p.effect.dz)},
            {"d", orNull(p.effect.d)},
            {"g", orNull(p.effect.g)},
            {"higher", p.signs.higher},
            {"lower", p.signs.lower},
            {"same", p.signs.same},
            {"unpaired", Json()},
            {"interval_ratio", orNull(p.intervalRatio())}};
  if (p.unpaired)
    json["unpaired"] = {
        {"low", p.unpaired->interval.low}, {"high", p.unpaired->interval.high}, {"p", p.unpaired->p}};
  if (p.equivalence) {
    const auto& e = *p.equivalence;
    json["equivalence"] = {{"margin", e.test.margin},
                           {"low", e.test.interval.low},
                           {"high", e.test.interval.high},
                           {"p", e.test.p},
                           {"p_holm", e.corrected},
                           {"p_beyond", e.test.pBeyond},
                           {"p_beyond_holm", e.correctedBeyond},
                           {"verdict", name(e.verdict)}};
  }
  return json;
}

Json asJson(const StudyComparison& c, const MeasureEffects& effects) {
  Json list = Json::array();
  for (std::size_t i = 0; i < effects.analysis.effects.size(); ++i) {
    const FactorEffect& e = effects.analysis.effects[i];
    Json axes = Json::array(), means = Json();
    for (const std::size_t f : e.factors) axes.push_back(c.results.axes[effects.axes[f]].name);
    if (e.factors.size() == 1) {
      means = Json::object();
      const auto& labels = c.results.axes[effects.axes[e.factors[0]]].labels;
      for (std::size_t l = 0; l < labels.size(); ++l) means[labels[l]] = effects.means[e.factors[0]][l];
    }
    list.push_back({{"axes", axes},
                    {"eta_squared", e.share},
                    {"partial_eta_squared", orNull(e.partial)},
                    {"df", e.degreesOfFreedom},
                    {"f", orNull(e.f)},
                    {"p", orNull(e.p)},
                    {"p_holm", orNull(effects.corrected[i])},
                    {"means", means}});
  }
  return {{"measure", c.measureName(effects.measure)},
          {"seeds", effects.seeds},
          {"error_df", effects.analysis.errorDegreesOfFreedom},
          {"untested", effects.untested.empty() ? Json() : Json(effects.untested)},
          {"effects", list}};
}

Json asJson(const StudyComparison& c, const TimeCourse& course) {
  Json points = Json::array();
  for (const auto& p : course.points) {
    Json point{{"time", p.time}, {"n", p.n}, {"mean", p.mean}};
    put(point, p.interval);
    points.push_back(point);
  }
  return {{"measure", c.measureName(course.measure)},
          {"labels", labelsOf(c.results, c.results.conditions[course.condition].levels)},
          {"points", points}};
}

Json unfinished(const StudyResults& r) {
  Json list = Json::array();
  for (const ResultCondition& condition : r.conditions)
    for (std::size_t s = 0; s < r.seeds.size(); ++s) {
      const std::size_t t = condition.tasks[s];
      if (t == noTask || r.tasks[t].status == "done") continue;
      list.push_back({{"labels", labelsOf(r, condition.levels)},
                      {"seed", r.seeds[s]},
                      {"task", r.tasks[t].id},
                      {"status", r.tasks[t].status},
                      {"reason", r.tasks[t].reason}});
    }
  return list;
}

}  // namespace

Json toJson(const StudyComparison& c) {
  const StudyResults& r = c.results;
  Json by = Json::array(), seedless = Json::array();
  for (const std::size_t a : c.by) by.push_back(r.axes[a].name);
  for (const std::size_t i : c.seedless) seedless.push_back(labelsOf(r, r.conditions[i].levels));
  const auto listOf = [&](const auto& rows) {
    Json list = Json::array();
    for (const auto& row : rows) list.push_back(asJson(c, row));
    return list;
  };
  return {{"study", r.name},
          {"by", by},
          {"troubles", troublesOf(r)},
          {"unfinished", unfinished(r)},
          {"seeds_change_nothing", seedless},
          {"verdicts", verdictsOf(c)},
          {"conditions", listOf(c.conditions)},
          {"pairs", listOf(c.pairs)},
          {"effects", listOf(c.effects)},
          {"courses", listOf(c.courses)}};
}

}  // namespace morula
