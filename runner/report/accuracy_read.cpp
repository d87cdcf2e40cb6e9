#include "report/accuracy_read.h"

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
  const auto found = j.find(key);
  return found == j.end() ? none : *found;
}

AccuracyEntry entryFrom(const Json& j) {
  AccuracyEntry e;
  e.series = j.at("series"), e.engine = j.at("engine");
  e.timeStep = j.at("settings").at("time_step");
  e.set = j.at("settings").at("set").get<std::vector<std::string>>();
  e.whole = realOr(j.at("error")), e.onMesh = realOr(j.at("error_on_scenario_mesh"));
  if (const Json& parts = j.at("parts"); parts.is_object()) {
    e.time = realOr(parts.at("time")), e.mesh = realOr(parts.at("mesh"));
    e.precision = realOr(parts.at("precision")), e.model = realOr(parts.at("model"));
  }
  e.partedAt = realOr(j.at("lineages_part_at"));
  e.resolved = j.at("resolved"), e.cutElsewhere = j.at("divided_elsewhere").is_object();
  e.cpuSeconds = j.at("cpu_seconds");
  e.evaluations = j.at("force_evaluations"), e.steps = j.at("steps");
  if (j.at("failed").get<bool>()) {
    e.failure = textOr(j.at("failure"));
    if (e.failure.empty()) e.failure = "it says not why";
  }
  return e;
}

void readReference(const Json& j, AccuracyRead& read) {
  auto& r = read.reference;
  r.integrator = j.at("settings").at("integrator"), r.witness = j.at("witness").at("integrator");
  r.timeStep = j.at("settings").at("time_step"), r.witnessTimeStep = j.at("witness").at("time_step");
  r.order = j.at("observed_order"), r.agrees = j.at("agrees");
  r.error = realOr(j.at("own_error")), r.witnessDistance = realOr(j.at("witness_distance"));
  r.witnessError = realOr(j.at("witness_own_error"));
}

void readMesh(const Json& j, AccuracyRead& read) {
  auto& m = read.mesh;
  m.error = realOr(j.at("error")), m.unknown = textOr(j.at("unknown")), m.limit = textOr(j.at("limit"));
  if (j.at("icosphere").is_number()) m.icosphere = j.at("icosphere").get<int>();
  m.order = j.at("order"), m.orderIsObserved = j.at("order_is_observed");
  m.partedAt = realOr(j.at("lineages_part_at"));
  for (const Json& level : j.at("levels")) {
    const Json& most = level.at("largest");
    m.levels.push_back({level.at("icosphere"), level.at("error"), most.at("position"), most.at("volume"),
                        most.at("surface"), most.at("pressure"), most.at("contact_area")});
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
  read.scenario = j.at("scenario");
  read.file = textOr(valueOf(j, "file"));
  read.until = j.at("times").empty() ? 0 : j.at("times").back().get<double>();
  read.end = realOr(j.at("end"));
  readReference(j.at("reference"), read);
  readMesh(j.at("mesh"), read);
  read.own = entryFrom(j.at("as_it_is"));
  if (const Json& rival = j.at("rival"); rival.is_object())
    read.rival = rival.at("series"), read.rivalSpeed = rival.at("speed");
  for (const Json& row : j.at("rows")) read.rows.push_back(entryFrom(row));
  for (const Json& o : j.at("orders"))
    read.orders.push_back({o.at("series"), o.at("theory"), realOr(o.at("standard_error")).value_or(0),
                           realOr(o.at("observed")), o.at("points")});
  for (const Json& s : j.at("beside_bullet"))
    read.besideBullet.push_back({s.at("error"), s.at("cpu_seconds"), s.at("bullet_cpu_seconds"),
                                 s.at("bullet_slowest_cpu_seconds"), s.at("series"), s.at("bullet_series")});
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
