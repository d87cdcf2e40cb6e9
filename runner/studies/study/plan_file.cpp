// Writes a plan as a file, and reads it.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "observation/asked_measure.h"
#include "study/conditions.h"
#include "system/json_record.h"

namespace morula {

// The fields of each struct in a plan's file, in their order.

template <IsA<Override> T>
void listFields(T& change, auto&& field) {
  auto& [path, value, place, removes] = change;
  field({"key"}, path);
  field({"value"}, value);
  field({"removes"}, removes);
  field({"place"}, place);
}

template <IsA<Level> T>
void listFields(T& level, auto&& field) {
  auto& [label, overrides] = level;
  field({"label"}, label);
  field({"changes"}, overrides);
}

template <IsA<StudyAxis> T>
void listFields(T& axis, auto&& field) {
  auto& [name, levels] = axis;
  field({"name"}, name);
  field({"levels"}, levels);
}

/// `place` comes from a study file and is not stored.
template <IsA<Base> T>
void listFields(T& base, auto&& field) {
  auto& [label, file, place] = base;
  field({"label"}, label);
  field({"file"}, file);
}

template <IsA<Kept> T>
void listFields(T& keep, auto&& field) {
  auto& [hashes, samples, pictures] = keep;
  field({"hashes"}, hashes);
  field({"samples"}, samples);
  field({"pictures"}, pictures);
}

template <IsA<RunLimits> T>
void listFields(T& limits, auto&& field) {
  auto& [cpu, memory] = limits;
  field({"cpu_per_run"}, cpu);
  field({"memory_per_run"}, memory);
}

/// `measurePlaces`, `allowOutside` and `claims` are known of a study file alone; `allowed` and `leftOut` are read from
/// its text.
template <IsA<Study> T>
void listFields(T& study, auto&& field) {
  auto& [file, bytes, name, summary, bases, axes, seeds, measures, when, keep, limits, allowed, measurePlaces,
         allowOutside, leftOut, claims] = study;
  field({"file"}, file);
  field({"name"}, name);
  field({"summary"}, summary);
  field({"bases"}, bases);
  field({"axes"}, axes);
  field({"seeds"}, seeds);
  field({"measures"}, measures);
  field({"when"}, when.moments);
  field({"every"}, when.every);
  field({"keep"}, keep);
  field({"limits"}, limits);
  field({"text"}, bytes);
}

template <IsA<Task> T>
void listFields(T& task, auto&& field) {
  auto& [id, condition, seed] = task;
  field({"id"}, id);
  field({"condition"}, condition);
  field({"seed"}, seed);
}

template <IsA<RunCost> T>
void listFields(T& cost, auto&& field) {
  auto& [seconds, memory, disk, tried] = cost;
  field({"cpu_seconds"}, seconds);
  field({"memory"}, memory);
  field({"disk"}, disk);
  field({"tried"}, tried);
}

namespace {

constexpr int formatVersion = 1;

/// The files of a plan; equal files are stored once.
class FileList {
 public:
  std::size_t add(const std::string& role, const std::string& path, const std::string& text) {
    const auto [at, isNew] = numbers_.try_emplace({role, path, text}, list_.size());
    if (isNew) list_.push_back({{"role", role}, {"path", path}, {"text", text}});
    return at->second;
  }
  Json take() { return std::move(list_); }

 private:
  std::map<std::array<std::string, 3>, std::size_t> numbers_;
  Json list_ = Json::array();
};

std::string hashOf(const std::string& text) {
  Hasher hasher;
  return hasher.field("plan file").add(text).digest().text();
}

Json membersOf(const Plan& plan) {
  FileList files;
  Json conditions = Json::array(), replicates = Json::array();
  for (const Condition& c : plan.conditions) {
    Json named = Json::array();
    for (const NamedFile& file : c.scenario.files) named.push_back(files.add(file.role, file.path, file.content));
    conditions.push_back({{"labels", c.labels},
                          {"scenario", files.add("scenario", c.scenario.file, c.scenario.bytes)},
                          {"files", std::move(named)},
                          {"uses_seed", c.usesSeed},
                          {"meaning", c.meaning.text()}});
  }
  for (const Replicate& r : plan.replicates) replicates.push_back(Json::array({r.condition, r.seed, r.task}));
  return {{"morula-plan", formatVersion},    {"id", plan.id},
          {"study", toJson(plan.study)},     {"conditions", std::move(conditions)},
          {"tasks", memberJson(plan.tasks)}, {"replicates", std::move(replicates)},
          {"costs", memberJson(plan.costs)}, {"files", files.take()}};
}

/// Writes a line for each entry of a list, so that people can read the file and its differences.
std::string textOf(const Json& members) {
  std::string text = "{\n";
  for (const auto& [key, value] : members.items()) {
    text += "  " + jsonText(Json(key)) + ": ";
    if (value.is_array() && !value.empty()) {
      for (std::size_t i = 0; i < value.size(); ++i) text += (i ? ",\n    " : "[\n    ") + jsonText(value[i]);
      text += "\n  ]";
    } else {
      text += jsonText(value);
    }
    text += ",\n";
  }
  return text;
}

Study studyOf(const Json& json) {
  auto s = fromJson<Study>(json);
  for (const StudyAxis& axis : s.axes)
    if (axis.levels.empty()) throw FileError("an axis has no levels");
  for (const std::string& name : s.measures)
    if (!findMeasure(name)) throw FileError("this build knows no measure '" + name + "'");
  if (s.seeds.empty() || s.bases.empty()) throw FileError("there are no seeds or no scenarios");
  s.allowed = allowedIn(s.bytes);
  addLeftOut(s);
  return s;
}

NamedFile fileOf(const Json& files, const Json& number) {
  const Json& file = files.at(wholeFrom<std::size_t>(number));
  return {file.at("role").get<std::string>(), file.at("path").get<std::string>(), file.at("text").get<std::string>()};
}

Plan planOf(const Json& json) {
  Plan plan;
  plan.study = studyOf(json.at("study"));
  const Json &conditions = json.at("conditions"), &files = json.at("files");
  plan.conditions = study::conditionsOf(plan.study);
  if (conditions.size() != plan.conditions.size()) throw FileError("the plan lacks conditions");
  for (Condition& condition : plan.conditions) {
    const Json& c = conditions[condition.number];
    const NamedFile base = fileOf(files, c.at("scenario"));
    std::vector<NamedFile> named;
    for (const Json& number : c.at("files")) named.push_back(fileOf(files, number));
    condition.scenario = study::readConditionScenario(plan.study, condition, base.content, base.path, "", named);
    condition.scenario.warnings.clear();
    study::finish(condition, plan.study);
    if (condition.meaning.text() != c.at("meaning").get<std::string>())
      throw FileError("its condition " + nameOf(plan, condition.number) +
                      " has another meaning for this build of Morula than for the build that made the plan");
  }
  study::addTasks(plan);
  readMember(json.at("costs"), plan.costs);
  if (!plan.costs.empty() && plan.costs.size() != plan.conditions.size()) throw FileError("the plan lacks costs");
  plan.id = study::planId(plan);
  if (plan.id != json.at("id").get<std::string>() || membersOf(plan) != json)
    throw FileError("the plan has another meaning for this build of Morula than for the build that made it");
  return plan;
}

}  // namespace

std::string writePlan(const Plan& plan) {
  const std::string text = textOf(membersOf(plan));
  return text + "  \"hash\": " + jsonText(Json(hashOf(text))) + "\n}\n";
}

Plan readPlan(const std::string& text, const std::string& file) {
  const auto fail = [&](const std::string& what, const std::string& remedy) {
    return FileError("'" + file + "' " + what + "; " + remedy);
  };
  Json json = tryParseJson(text);
  if (!json.is_object() || !json.contains("morula-plan"))
    throw fail("is no plan of a study", "morula study plan makes one");
  if (json["morula-plan"] != formatVersion)
    throw fail("is a plan of another version of Morula", "run it with that, or plan again in a new folder");
  const auto end = text.rfind("  \"hash\": ");
  if (end == text.npos || !json.contains("hash") || json["hash"] != hashOf(text.substr(0, end)))
    throw fail("is damaged, because it has been changed since it was made",
               "restore it from a copy, or plan again in a new folder");
  json.erase("hash");
  const std::string again = "plan again in a new folder, or use the build that made it";
  try {
    return planOf(json);
  } catch (const Json::exception& error) {
    throw fail(std::string("is no whole plan: ") + error.what(), again);
  } catch (const InputError& error) {
    throw fail(std::string("has a scenario that this build refuses: ") + error.what(), again);
  } catch (const FileError& error) { throw fail(std::string("cannot be used: ") + error.what(), again); }
}

}  // namespace morula
