// Accuracy for other programs: as JSON, which pages are made from, and its rows as CSV.
#include <stdexcept>

#include "accuracy/accuracy.h"
#include "system/json_record.h"

namespace morula {

template <IsA<Setting> T>
void listFields(T& s, auto&& field) {
  auto& [integrator, timeStep, precision, level, law, substeps, model, automatic, autoShare, coarsen] = s;
  field({"integrator"}, integrator);
  field({"time_step"}, timeStep);
  field({"automatic_share"}, ValueOf{[&] { return s.automatic ? std::optional(s.autoShare) : std::nullopt; },
                                     [&](const auto& share) {
                                       s.automatic = share.has_value();
                                       if (share) s.autoShare = *share;
                                     }});
  field({"icosphere"}, level);
  field({"substeps"}, ValueOf{[&] { return s.substeps.value_or(1); }, notRead});
  field({"precision"}, precision);
  field({"contact_law"}, law);
  field({"cell_model"}, ValueOf{[&] { return s.model ? std::optional(s.model->model) : std::nullopt; }, notRead});
  field({"set"}, ValueOf{[&] { return changesFor(s); }, notRead});
}

template <IsA<DividedElsewhere> T>
void listFields(T& cut, auto&& field) {
  auto& [mother, time, angle, extentRatio] = cut;
  field({"path"}, mother);
  field({"time"}, time);
  field({"angle"}, angle);
  field({"extent_ratio"}, extentRatio);
}

template <IsA<ErrorParts> T>
void listFields(T& parts, auto&& field) {
  auto& [time, mesh, precision, model] = parts;
  field({"time"}, time);
  field({"mesh"}, mesh);
  field({"precision"}, precision);
  field({"model"}, model);
}

template <IsA<StateError> T>
void listFields(T& errors, auto&& field) {
  for (const ErrorQuantity& q : errorQuantities) field({q.name}, errors.*q.of);
}

template <IsA<AccuracyRow> T>
void listFields(T& row, auto&& field) {
  ValueOf sum{[&] { return row.parts.sum(); }, notRead};
  ValueOf errors{[&] {
                   Json json = toJson(row.errors);
                   json["birth_times"] = row.birthTimes;
                   return json;
                 },
                 [&](const auto& json) {
                   row.errors = fromJson<StateError>(json);
                   readMember(json.at("birth_times"), row.birthTimes);
                 }};
  field({"settings"}, row.setting);
  field({"engine"}, row.engine);
  field({"series"}, row.series);
  field({"error"}, NullIf{!row.error, sum});
  field({"parts"}, NullIf{!row.error, row.parts});
  field({"error_on_scenario_mesh"}, row.error);
  field({"divided_elsewhere"}, row.cut);
  field({"errors"}, NullIf{!row.error, errors});
  field({"resolved"}, row.resolved);
  field({"lineages_part_at"}, row.partedAt);
  field({"until"}, row.until);
  field({"cpu_seconds"}, row.cpuSeconds);
  field({"force_evaluations"}, row.forceEvaluations);
  field({"vertex_steps"}, row.vertexSteps);
  field({"steps"}, row.steps);
  field({"failed"}, ValueOf{[&] { return !row.failure.empty(); },
                            [&](const auto& failed) { row.failure = failed ? "no reason is given" : ""; }});
  field({"failure"}, NullIf{row.failure.empty(), row.failure});
}

/// In JSON an unknown error, infinite or NaN, is null.
template <IsA<AccuracyReference> T>
void listFields(T& r, auto&& field) {
  auto& [setting, witness, left, witnessLeft, distance, agrees] = r;
  field({"settings"}, setting);
  field({"own_error"}, AnyReal{left.error});
  field({"observed_order"}, left.order);
  field({"witness"}, witness);
  field({"witness_distance"}, AnyReal{distance});
  field({"witness_own_error"}, AnyReal{witnessLeft.error});
  field({"agrees"}, agrees);
}

template <IsA<LevelError> T>
void listFields(T& l, auto&& field) {
  auto& [level, worst, atEnd, atRest] = l;
  field({"icosphere"}, level);
  field({"error"}, ValueOf{[&] { return l.worst.largest(); }, notRead});
  field({"largest"}, worst);
  field({"at_end"}, atEnd);
  field({"at_rest"}, atRest);
}

template <IsA<MeshError> T>
void listFields(T& mesh, auto&& field) {
  auto& [unknown, limit, none, levels, own, order, orderIsObserved, atStart, until, partedAt, cut, touch, timeError,
         cpuSeconds] = mesh;
  field({"error"}, ValueOf{[&] { return mesh.error(); }, notRead});
  field({"unknown"}, NullIf{unknown.empty(), unknown});
  field({"limit"}, NullIf{limit.empty(), limit});
  field({"icosphere"},
        ValueOf{[&] { return mesh.none || mesh.levels.empty() ? std::nullopt : std::optional(mesh.own); },
                [&](const auto& level) {
                  mesh.none = mesh.unknown.empty() && !level;
                  mesh.own = level.value_or(0);
                }});
  field({"levels"}, levels);
  field({"order"}, order);
  field({"order_is_observed"}, orderIsObserved);
  field({"surface_at_start"}, atStart);
  field({"until"}, until);
  field({"lineages_part_at"}, partedAt);
  field({"divided_elsewhere"}, cut);
  field({"cells_touch"}, touch);
  field({"time_error"}, timeError);
  field({"cpu_seconds"}, cpuSeconds);
}

template <IsA<Rival> T>
void listFields(T& rival, auto&& field) {
  auto& [series, cpuSeconds, speed] = rival;
  field({"series"}, series);
  field({"cpu_seconds"}, cpuSeconds);
  field({"speed"}, speed);
}

void setIn(std::optional<PowerLaw>& law, double PowerLaw::*member, const auto& value) {
  if (!value) return;
  if (!law) law.emplace();
  (*law).*member = *value;
}

template <IsA<SeriesOrder> T>
void listFields(T& o, auto&& field) {
  auto& [series, theory, observed] = o;
  const auto ofLaw = [&](double PowerLaw::*member) {
    return ValueOf{[&o, member] { return o.observed ? std::optional((*o.observed).*member) : std::nullopt; },
                   [&o, member](const auto& value) { setIn(o.observed, member, value); }};
  };
  field({"series"}, series);
  field({"theory"}, theory);
  field({"observed"}, ofLaw(&PowerLaw::slope));
  field({"standard_error"}, ofLaw(&PowerLaw::slopeError));
  field({"points"}, ValueOf{[&] { return o.observed ? o.observed->points : 0; },
                            [&](const auto& points) {
                              if (o.observed) o.observed->points = points;
                            }});
}

template <IsA<SpeedAtError> T>
void listFields(T& s, auto&& field) {
  auto& [error, series, cpuSeconds, forceEvaluations, speed] = s;
  field({"error"}, error);
  field({"series"}, series);
  field({"cpu_seconds"}, cpuSeconds);
  field({"force_evaluations"}, forceEvaluations);
  field({"speed"}, speed);
}

template <IsA<BulletSpeed> T>
void listFields(T& s, auto&& field) {
  auto& [error, ours, bullets, ourSeconds, bulletSeconds, bulletMostSeconds] = s;
  field({"error"}, error);
  field({"series"}, ours);
  field({"cpu_seconds"}, ourSeconds);
  field({"bullet_series"}, bullets);
  field({"bullet_cpu_seconds"}, bulletSeconds);
  field({"bullet_slowest_cpu_seconds"}, bulletMostSeconds);
}

template <IsA<GoldenError> T>
void listFields(T& error, auto&& field) {
  auto& [quantity, rest, worst, until, meshRest, meshWorst, meshUntil, line] = error;
  field({"quantity"}, quantity);
  field({"at_rest"}, rest);
  field({"at_worst"}, worst);
  field({"until"}, until);
  field({"mesh_at_rest"}, meshRest);
  field({"mesh_at_worst"}, meshWorst);
  field({"mesh_until"}, meshUntil);
}

template <IsA<GoldenUnstated> T>
void listFields(T& unstated, auto&& field) {
  auto& [of, why, line] = unstated;
  field({"of"}, of);
  field({"why"}, why.text);
}

template <IsA<StatedErrors> T>
void listFields(T& stated, auto&& field) {
  auto& [errors, unstated, times, quietTimes, events] = stated;
  field({"errors"}, errors);
  field({"unstated"}, unstated);
  field({"times"}, times);
  field({"quiet_times"}, quietTimes);
  field({"events"}, events);
}

template <IsA<AccuracyReport> T>
void listFields(T& report, auto&& field) {
  auto& [scenario, usual, own, rival, mesh, stated, times, end, horizon, reference, rows, orders, speeds, bulletSpeeds,
         remarks] = report;
  field({"scenario"}, scenario);
  field({"times"}, times);
  field({"end"}, end);
  field({"reference"}, reference);
  field({"mesh"}, mesh);
  field({"as_it_is"}, own);
  field({"stated"}, stated);
  field({"rival"}, rival);
  field({"rows"}, rows);
  field({"orders"}, orders);
  field({"speed_at_error"}, speeds);
  field({"beside_bullet"}, bulletSpeeds);
  field({"remarks"}, remarks);
}

Json toJson(const Setting& setting) { return toJson<Setting>(setting); }

Json toJson(const AccuracyReport& report, const std::string& picture) {
  Json json = toJson<AccuracyReport>(report);
  json["picture"] = picture;
  return json;
}

AccuracyReport accuracyFrom(const Json& json) {
  auto report = fromJson<AccuracyReport>(json);
  if (report.times.empty()) throw std::invalid_argument("no times");
  const auto readSet = [](const Json& row, AccuracyRow& to) { readMember(row.at("settings").at("set"), to.set); };
  readSet(json.at("as_it_is"), report.own);
  for (std::size_t i = 0; i < report.rows.size(); ++i) readSet(json.at("rows").at(i), report.rows[i]);
  return report;
}

std::string accuracyCsv(const Json& rows) {
  struct Members {
    std::string of, prefix;  // of: "" for fields of the row itself
    std::vector<const char*> names;
  };
  Members all[] = {
      {"", "", {"series", "engine"}},
      {"settings", "", {"integrator", "time_step", "icosphere", "substeps", "precision", "contact_law", "cell_model"}},
      {"parts", "error_of_", {"time", "mesh", "precision", "model"}},
      {"errors", "error_in_", {"birth_times"}},
      {"", "", {"error", "error_on_scenario_mesh", "resolved", "lineages_part_at", "cpu_seconds"}},
      {"", "", {"force_evaluations", "vertex_steps", "steps", "failed", "failure"}}};
  for (const ErrorQuantity& q : errorQuantities) all[3].names.push_back(q.name);
  Table table{"Settings", {}};
  for (const Members& members : all)
    for (const char* name : members.names) table.columns.push_back({"", members.prefix + name, ""});
  for (const Json& row : rows) {
    table.rows.emplace_back();
    for (const Members& members : all) {
      const Json& of = members.of.empty() ? row : row.at(members.of);
      for (const char* name : members.names) table.rows.back().push_back(exact(of.is_object() ? of.at(name) : Json()));
    }
  }
  return csvOf(table);
}

}  // namespace morula
