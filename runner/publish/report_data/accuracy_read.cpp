#include "report_data/accuracy_read.h"

#include "base/number_text.h"

namespace morula {

namespace {

std::optional<double> realOr(const Json& j) {
  return j.is_number() ? std::optional(j.get<double>()) : std::nullopt;
}

std::string textOr(const Json& j) { return j.is_string() ? j.get<std::string>() : ""; }

/// The value of a key that older outputs have not.
const Json& valueOf(const Json& j, const char* key) {
  static const Json none;
  return j.contains(key) ? j.at(key) : none;
}

AccuracyEntry entryFrom(const Json& j) {
  AccuracyEntry e;
  j.at("series").get_to(e.series), j.at("engine").get_to(e.engine);
  j.at("settings").at("time_step").get_to(e.timeStep);
  e.set = j.at("settings").at("set").get<std::vector<std::string>>();
  e.whole = realOr(j.at("error")), e.onMesh = realOr(j.at("error_on_scenario_mesh"));
  if (const Json& parts = j.at("parts"); parts.is_object()) {
    e.time = realOr(parts.at("time")), e.mesh = realOr(parts.at("mesh"));
    e.precision = realOr(parts.at("precision")), e.model = realOr(parts.at("model"));
  }
  e.partedAt = realOr(j.at("lineages_part_at"));
  j.at("resolved").get_to(e.resolved), e.cutElsewhere = j.at("divided_elsewhere").is_object();
  j.at("cpu_seconds").get_to(e.cpuSeconds);
  j.at("force_evaluations").get_to(e.evaluations), j.at("steps").get_to(e.steps);
  if (j.at("failed").get<bool>()) {
    e.failure = textOr(j.at("failure"));
    if (e.failure.empty()) e.failure = "it says not why";
  }
  return e;
}

void readReference(const Json& j, AccuracyRead& read) {
  auto& r = read.reference;
  j.at("settings").at("integrator").get_to(r.integrator), j.at("witness").at("integrator").get_to(r.witness);
  j.at("settings").at("time_step").get_to(r.timeStep),
      j.at("witness").at("time_step").get_to(r.witnessTimeStep);
  j.at("observed_order").get_to(r.order), j.at("agrees").get_to(r.agrees);
  r.error = realOr(j.at("own_error")), r.witnessDistance = realOr(j.at("witness_distance"));
  r.witnessError = realOr(j.at("witness_own_error"));
}

void readMesh(const Json& j, AccuracyRead& read) {
  auto& m = read.mesh;
  m.error = realOr(j.at("error")), m.unknown = textOr(j.at("unknown")), m.limit = textOr(j.at("limit"));
  if (j.at("icosphere").is_number()) m.icosphere = j.at("icosphere").get<int>();
  j.at("order").get_to(m.order), j.at("order_is_observed").get_to(m.orderIsObserved);
  m.partedAt = realOr(j.at("lineages_part_at"));
  for (const Json& level : j.at("levels")) {
    const Json& most = level.at("largest");
    const auto number = [&](const char* name) { return most.at(name).get<double>(); };
    m.levels.push_back({level.at("icosphere").get<int>(), level.at("error").get<double>(), number("position"),
                        number("volume"), number("surface"), number("pressure"), number("contact_area")});
  }
}

std::string csvField(const Json& j) {
  if (j.is_null()) return "";
  if (j.is_number_float()) return exactText(j.get<double>());
  const std::string text = j.is_string() ? j.get<std::string>() : jsonText(j);
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

bool AccuracyEntry::holds(double error, double referenceError) const {
  return failure.empty() && onMesh && !partedAt && *onMesh + referenceError <= error;
}

AccuracyRead accuracyFrom(const Json& j) {
  AccuracyRead read;
  j.at("scenario").get_to(read.scenario);
  read.file = textOr(valueOf(j, "file"));
  if (const Json& times = j.at("times"); !times.empty()) times.at(times.size() - 1).get_to(read.until);
  read.end = realOr(j.at("end"));
  readReference(j.at("reference"), read);
  readMesh(j.at("mesh"), read);
  read.own = entryFrom(j.at("as_it_is"));
  if (const Json& rival = j.at("rival"); rival.is_object())
    rival.at("series").get_to(read.rival), rival.at("speed").get_to(read.rivalSpeed);
  for (const Json& row : j.at("rows")) read.rows.push_back(entryFrom(row));
  for (const Json& o : j.at("orders"))
    read.orders.push_back({o.at("series").get<std::string>(), o.at("theory").get<double>(),
                           realOr(o.at("standard_error")).value_or(0), realOr(o.at("observed")),
                           o.at("points").get<int>()});
  for (const Json& s : j.at("beside_bullet")) {
    const auto number = [&](const char* name) { return s.at(name).get<double>(); };
    read.besideBullet.push_back({number("error"), number("cpu_seconds"), number("bullet_cpu_seconds"),
                                 number("bullet_slowest_cpu_seconds"), s.at("series").get<std::string>(),
                                 s.at("bullet_series").get<std::string>()});
  }
  read.remarks = j.at("remarks").get<std::vector<std::string>>();
  read.target = valueOf(j, "target");
  if (const Json& made = valueOf(j, "made_by"); made.is_object())
    for (const auto& [name, value] : made.items()) read.provenance.push_back({name, textOr(value)});
  return read;
}

std::string accuracyCsv(const Json& rows) {
  constexpr const char* ofSettings[] = {"integrator", "time_step",   "icosphere", "substeps",
                                        "precision",  "contact_law", "cell_model"};
  constexpr const char* ofParts[] = {"time", "mesh", "precision", "model"};
  constexpr const char* ofErrors[] = {"centroid", "volume", "surface", "birth_times"};
  constexpr const char* own[] = {"error",        "error_on_scenario_mesh",
                                 "resolved",     "lineages_part_at",
                                 "cpu_seconds",  "force_evaluations",
                                 "vertex_steps", "steps",
                                 "failed",       "failure"};
  std::string text = "series,engine";
  for (const char* name : ofSettings) text += std::string(",") + name;
  for (const char* name : ofParts) text += std::string(",error_of_") + name;
  for (const char* name : ofErrors) text += std::string(",error_in_") + name;
  for (const char* name : own) text += std::string(",") + name;
  text += "\r\n";
  for (const Json& row : rows) {
    const auto add = [&](const Json& of, const char* name) {
      text += ',' + (of.is_object() ? csvField(of.at(name)) : std::string());
    };
    text += csvField(row.at("series")) + ',' + csvField(row.at("engine"));
    for (const char* name : ofSettings) add(row.at("settings"), name);
    for (const char* name : ofParts) add(row.at("parts"), name);
    for (const char* name : ofErrors) add(row.at("errors"), name);
    for (const char* name : own) add(row, name);
    text += "\r\n";
  }
  return text;
}

const AccuracyEntry* cheapestFor(const AccuracyRead& read, double error, bool ours) {
  const AccuracyEntry* best = nullptr;
  for (const AccuracyEntry& e : read.rows)
    if (e.isOurs() == ours && e.holds(error, read.referenceError()) &&
        (!best || e.cpuSeconds < best->cpuSeconds))
      best = &e;
  return best;
}

}  // namespace morula
