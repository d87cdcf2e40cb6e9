// What accuracy --json has printed, read back as far as people are shown it.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "accuracy/accuracy.h"

namespace morula {

namespace {

std::optional<double> realOr(const Json& j) {
  return j.is_number() ? std::optional(j.get<double>()) : std::nullopt;
}

std::string textOr(const Json& j) { return j.is_string() ? j.get<std::string>() : ""; }

/// What is null was infinite.
double finite(const Json& j) { return realOr(j).value_or(INFINITY); }

template <class E>
E choiceFrom(const Json& j) {
  const auto all = valuesOf<E>();
  const auto* found = std::ranges::find(all, j.get<std::string>(), nameOf<E>);
  if (found == all.end()) throw std::invalid_argument("no such choice");
  return *found;
}

Setting settingFrom(const Json& j) {
  Setting s;
  s.integrator = choiceFrom<Integrator>(j.at("integrator"));
  s.precision = choiceFrom<Precision>(j.at("precision"));
  j.at("time_step").get_to(s.timeStep);
  s.automatic = j.at("automatic_share").is_number();
  if (s.automatic) j.at("automatic_share").get_to(s.autoShare);
  return s;
}

AccuracyRow rowFrom(const Json& j) {
  AccuracyRow row;
  row.setting = settingFrom(j.at("settings"));
  row.set = j.at("settings").at("set").get<std::vector<std::string>>();
  j.at("series").get_to(row.series), j.at("engine").get_to(row.engine);
  row.error = realOr(j.at("error_on_scenario_mesh"));
  if (const Json& parts = j.at("parts"); parts.is_object())
    row.parts = {realOr(parts.at("time")), realOr(parts.at("mesh")), realOr(parts.at("precision")),
                 realOr(parts.at("model"))};
  if (const Json& errors = j.at("errors"); errors.is_object()) {
    errors.at("centroid").get_to(row.errors.centroid), errors.at("volume").get_to(row.errors.volume);
    errors.at("surface").get_to(row.errors.surface), errors.at("birth_times").get_to(row.birthTimes);
  }
  if (const Json& cut = j.at("divided_elsewhere"); cut.is_object())
    cut.at("time").get_to(row.cut.emplace().time);
  row.partedAt = realOr(j.at("lineages_part_at"));
  j.at("resolved").get_to(row.resolved);
  j.at("cpu_seconds").get_to(row.cpuSeconds);
  j.at("force_evaluations").get_to(row.forceEvaluations), j.at("steps").get_to(row.steps);
  if (j.at("failed").get<bool>())
    row.failure = j.at("failure").is_string() ? textOr(j.at("failure")) : "it says not why";
  return row;
}

AccuracyReference referenceFrom(const Json& j) {
  AccuracyReference r;
  r.setting = settingFrom(j.at("settings")), r.witness = settingFrom(j.at("witness"));
  r.left = {finite(j.at("own_error")), j.at("observed_order").get<double>()};
  r.distance = finite(j.at("witness_distance")), r.witnessLeft.error = finite(j.at("witness_own_error"));
  j.at("agrees").get_to(r.agrees);
  return r;
}

MeshError meshFrom(const Json& j) {
  MeshError mesh;
  mesh.unknown = textOr(j.at("unknown")), mesh.limit = textOr(j.at("limit"));
  mesh.none = mesh.unknown.empty() && !j.at("icosphere").is_number();
  if (j.at("icosphere").is_number()) j.at("icosphere").get_to(mesh.own);
  j.at("order").get_to(mesh.order), j.at("order_is_observed").get_to(mesh.orderIsObserved);
  mesh.partedAt = realOr(j.at("lineages_part_at"));
  for (const Json& level : j.at("levels")) {
    LevelError& error = mesh.levels.emplace_back();
    level.at("icosphere").get_to(error.level);
    const Json& most = level.at("largest");
    most.at("position").get_to(error.worst.centroid), most.at("volume").get_to(error.worst.volume);
    most.at("surface").get_to(error.worst.surface), most.at("pressure").get_to(error.worst.pressure);
    most.at("contact_area").get_to(error.worst.contactArea);
  }
  return mesh;
}

}  // namespace

AccuracyReport accuracyFrom(const Json& j) {
  AccuracyReport report;
  j.at("scenario").get_to(report.scenario);
  report.times = j.at("times").get<std::vector<double>>();
  if (report.times.empty()) throw std::invalid_argument("no times");
  report.end = realOr(j.at("end"));
  report.reference = referenceFrom(j.at("reference"));
  report.mesh = meshFrom(j.at("mesh"));
  report.own = rowFrom(j.at("as_it_is"));
  if (const Json& r = j.at("rival"); r.is_object())
    report.rival = Rival{r.at("series").get<std::string>(), r.at("cpu_seconds").get<double>(),
                         r.at("speed").get<double>()};
  for (const Json& row : j.at("rows")) report.rows.push_back(rowFrom(row));
  for (const Json& o : j.at("orders")) {
    SeriesOrder& order = report.orders.emplace_back(
        SeriesOrder{o.at("series").get<std::string>(), o.at("theory").get<double>(), {}});
    if (const auto slope = realOr(o.at("observed")))
      order.observed =
          PowerLaw{*slope, realOr(o.at("standard_error")).value_or(0), o.at("points").get<int>()};
  }
  for (const Json& s : j.at("beside_bullet"))
    report.bulletSpeeds.push_back(
        {s.at("error").get<double>(), s.at("series").get<std::string>(),
         s.at("bullet_series").get<std::string>(), s.at("cpu_seconds").get<double>(),
         s.at("bullet_cpu_seconds").get<double>(), s.at("bullet_slowest_cpu_seconds").get<double>()});
  report.remarks = j.at("remarks").get<std::vector<std::string>>();
  return report;
}

std::string accuracyCsv(const Json& rows) {
  struct Members {
    std::string of, prefix;  // of: "" for those of the row itself
    std::vector<const char*> names;
  };
  static const Members all[] = {
      {"", "", {"series", "engine"}},
      {"settings",
       "",
       {"integrator", "time_step", "icosphere", "substeps", "precision", "contact_law", "cell_model"}},
      {"parts", "error_of_", {"time", "mesh", "precision", "model"}},
      {"errors", "error_in_", {"centroid", "volume", "surface", "birth_times"}},
      {"", "", {"error", "error_on_scenario_mesh", "resolved", "lineages_part_at", "cpu_seconds"}},
      {"", "", {"force_evaluations", "vertex_steps", "steps", "failed", "failure"}}};
  Table table{"Settings", {}};
  for (const Members& members : all)
    for (const char* name : members.names) table.columns.push_back({"", members.prefix + name, ""});
  for (const Json& row : rows) {
    table.rows.emplace_back();
    for (const Members& members : all) {
      const Json& of = members.of.empty() ? row : row.at(members.of);
      for (const char* name : members.names)
        table.rows.back().push_back(exact(of.is_object() ? of.at(name) : Json()));
    }
  }
  return csvOf(table);
}

}  // namespace morula
