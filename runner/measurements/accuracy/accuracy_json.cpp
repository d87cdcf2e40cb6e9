#include "accuracy/accuracy.h"

namespace morula {

Json toJson(const Setting& s) {
  return {{"integrator", nameOf(s.integrator)},
          {"time_step", s.timeStep},
          {"automatic_share", s.automatic ? Json(s.autoShare) : Json()},
          {"icosphere", orNull(s.level)},
          {"substeps", s.substeps.value_or(1)},
          {"precision", nameOf(s.precision)},
          {"contact_law", s.law ? Json(nameOf(*s.law)) : Json()},
          {"cell_model", s.model ? Json(nameOf(s.model->model)) : Json()},
          {"set", changesFor(s)}};
}

namespace {

using morula::toJson;  // of settings

Json toJson(const std::optional<DividedElsewhere>& cut) {
  if (!cut) return {};
  return {{"path", cut->mother.text()},
          {"time", cut->time},
          {"angle", cut->angle},
          {"extent_ratio", orNull(cut->extentRatio)}};
}

Json toJson(const AccuracyRow& row) {
  const bool known = row.error.has_value();
  return {{"settings", toJson(row.setting)},
          {"engine", row.engine},
          {"series", row.series},
          {"error", known ? Json(row.parts.sum()) : Json()},
          {"parts", known ? Json{{"time", orNull(row.parts.time)},
                                 {"mesh", orNull(row.parts.mesh)},
                                 {"precision", orNull(row.parts.precision)},
                                 {"model", orNull(row.parts.model)}}
                          : Json()},
          {"error_on_scenario_mesh", orNull(row.error)},
          {"divided_elsewhere", toJson(row.cut)},
          {"errors", known ? Json{{"centroid", row.errors.centroid},
                                  {"volume", row.errors.volume},
                                  {"surface", row.errors.surface},
                                  {"birth_times", row.birthTimes}}
                           : Json()},
          {"resolved", row.resolved},
          {"lineages_part_at", orNull(row.partedAt)},
          {"cpu_seconds", row.cpuSeconds},
          {"force_evaluations", row.forceEvaluations},
          {"vertex_steps", row.vertexSteps},
          {"steps", row.steps},
          {"failed", !row.failure.empty()},
          {"failure", row.failure.empty() ? Json() : Json(row.failure)}};
}

/// JSON has no infinity: an error that is not known is null.
Json finite(double a) { return a < 1e300 ? Json(a) : Json(); }

Json toJson(const AccuracyReference& r) {
  return {{"settings", toJson(r.setting)},
          {"own_error", finite(r.left.error)},
          {"observed_order", r.left.order},
          {"witness", toJson(r.witness)},
          {"witness_distance", finite(r.distance)},
          {"witness_own_error", finite(r.witnessLeft.error)},
          {"agrees", r.agrees}};
}

Json toJson(const MeshMeasures& m) {
  return {{"position", m.centroid},
          {"volume", m.volume},
          {"surface", m.surface},
          {"pressure", m.pressure},
          {"contact_area", m.contactArea}};
}

Json toJson(const MeshError& mesh) {
  Json levels = Json::array();
  for (const LevelError& level : mesh.levels)
    levels.push_back({{"icosphere", level.level},
                      {"error", level.worst.largest()},
                      {"largest", toJson(level.worst)},
                      {"at_end", toJson(level.atEnd)}});
  return {{"error", orNull(mesh.error())},
          {"unknown", mesh.unknown.empty() ? Json() : Json(mesh.unknown)},
          {"limit", mesh.limit.empty() ? Json() : Json(mesh.limit)},
          {"icosphere", mesh.none || mesh.levels.empty() ? Json() : Json(mesh.own)},
          {"levels", levels},
          {"order", mesh.order},
          {"order_is_observed", mesh.orderIsObserved},
          {"surface_at_start", mesh.atStart},
          {"until", mesh.until},
          {"lineages_part_at", orNull(mesh.partedAt)},
          {"divided_elsewhere", toJson(mesh.cut)},
          {"time_error", mesh.timeError},
          {"cpu_seconds", mesh.cpuSeconds}};
}

Json toJson(const SeriesOrder& o) {
  return {{"series", o.series},
          {"theory", o.theory},
          {"observed", o.observed ? Json(o.observed->slope) : Json()},
          {"standard_error", o.observed ? Json(o.observed->slopeError) : Json()},
          {"points", o.observed ? o.observed->points : 0}};
}

}  // namespace

Json toJson(const AccuracyReport& report, const std::string& picture) {
  Json rows = Json::array(), orders = Json::array(), speeds = Json::array();
  for (const auto& row : report.rows) rows.push_back(toJson(row));
  for (const auto& order : report.orders) orders.push_back(toJson(order));
  Json besideBullet = Json::array();
  for (const auto& s : report.bulletSpeeds)
    besideBullet.push_back({{"error", s.error},
                            {"series", s.ours},
                            {"cpu_seconds", s.ourSeconds},
                            {"bullet_series", s.bullets},
                            {"bullet_cpu_seconds", s.bulletSeconds},
                            {"bullet_slowest_cpu_seconds", s.bulletMostSeconds}});
  for (const auto& s : report.speeds)
    speeds.push_back({{"error", s.error},
                      {"series", s.series},
                      {"cpu_seconds", s.cpuSeconds},
                      {"force_evaluations", s.forceEvaluations},
                      {"speed", orNull(s.speed)}});
  return {{"scenario", report.scenario},
          {"times", report.times},
          {"end", orNull(report.end)},
          {"reference", toJson(report.reference)},
          {"mesh", toJson(report.mesh)},
          {"as_it_is", toJson(report.own)},
          {"rival", report.rival ? Json{{"series", report.rival->series},
                                        {"cpu_seconds", report.rival->cpuSeconds},
                                        {"speed", report.rival->speed}}
                                 : Json()},
          {"rows", rows},
          {"orders", orders},
          {"speed_at_error", speeds},
          {"beside_bullet", besideBullet},
          {"remarks", report.remarks},
          {"picture", picture}};
}

}  // namespace morula
