// A plan as a file, and back.
#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/utf8.h"
#include "study/conditions.h"
#include "study/plan_parts.h"
#include "study/study_measures.h"

namespace morula {

namespace {

constexpr int formatVersion = 1;

Json toJson(const StudyAxis& axis) {
  Json levels = Json::array();
  for (const Level& level : axis.levels) {
    Json changes = Json::array();
    for (const Override& change : level.overrides)
      changes.push_back({{"key", change.path},
                         {"value", change.value},
                         {"removes", change.removes},
                         {"place", change.place}});
    levels.push_back({{"label", level.label}, {"changes", std::move(changes)}});
  }
  return {{"name", axis.name}, {"levels", std::move(levels)}};
}

Json toJson(const Study& s) {
  Json bases = Json::array(), axes = Json::array();
  for (const Base& base : s.bases) bases.push_back({{"label", base.label}, {"file", base.file}});
  for (const StudyAxis& axis : s.axes) axes.push_back(toJson(axis));
  return {{"file", s.file},
          {"name", s.name},
          {"summary", s.summary},
          {"bases", std::move(bases)},
          {"axes", std::move(axes)},
          {"seeds", s.seeds},
          {"measures", s.measures},
          {"when", nameOf(s.when.moments)},
          {"every", s.when.every},
          {"keep",
           {{"hashes", nameOf(s.keep.hashes)},
            {"samples", nameOf(s.keep.samples)},
            {"pictures", nameOf(s.keep.pictures)}}},
          {"limits", {{"cpu_per_run", orNull(s.limits.cpu)}, {"memory_per_run", orNull(s.limits.memory)}}},
          {"text", s.bytes}};
}

/// Equal files once.
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
  Json conditions = Json::array(), tasks = Json::array(), replicates = Json::array(), costs = Json::array();
  for (const Condition& c : plan.conditions) {
    Json named = Json::array();
    for (const NamedFile& file : c.scenario.files)
      named.push_back(files.add(file.role, file.path, file.content));
    conditions.push_back({{"labels", c.labels},
                          {"scenario", files.add("scenario", c.scenario.file, c.scenario.bytes)},
                          {"files", std::move(named)},
                          {"uses_seed", c.usesSeed},
                          {"meaning", c.meaning.text()}});
  }
  for (const Task& t : plan.tasks)
    tasks.push_back({{"id", t.id}, {"condition", t.condition}, {"seed", t.seed}});
  for (const Replicate& r : plan.replicates) replicates.push_back(Json::array({r.condition, r.seed, r.task}));
  for (const RunCost& c : plan.costs)
    costs.push_back({{"cpu_seconds", c.seconds}, {"memory", c.memory}, {"disk", c.disk}, {"tried", c.tried}});
  return {{"morula-plan", formatVersion}, {"id", plan.id},
          {"study", toJson(plan.study)},  {"conditions", std::move(conditions)},
          {"tasks", std::move(tasks)},    {"replicates", std::move(replicates)},
          {"costs", std::move(costs)},    {"files", files.take()}};
}

/// One line for each entry of a list, so that people can read the file, and its differences.
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

template <class E>
E choiceOf(const Json& json) {
  const auto name = json.get<std::string>();
  for (const auto& row : choices<E>)
    if (row.name == name) return row.value;
  throw FileError("'" + name + "' is not one of " + namesOf<E>());
}

Study studyOf(const Json& json) {
  Study s;
  s.file = json.at("file").get<std::string>();
  s.bytes = json.at("text").get<std::string>();
  s.name = json.at("name").get<std::string>();
  s.summary = json.at("summary").get<std::string>();
  for (const Json& base : json.at("bases"))
    s.bases.push_back({base.at("label").get<std::string>(), base.at("file").get<std::string>(), {}});
  for (const Json& axis : json.at("axes")) {
    s.axes.push_back({axis.at("name").get<std::string>(), {}});
    for (const Json& level : axis.at("levels")) {
      Level& made = s.axes.back().levels.emplace_back(Level{level.at("label").get<std::string>(), {}});
      for (const Json& change : level.at("changes"))
        made.overrides.push_back({change.at("key").get<std::string>(), change.at("value").get<std::string>(),
                                  change.at("place").get<std::string>(), change.at("removes").get<bool>()});
    }
    if (s.axes.back().levels.empty()) throw FileError("an axis has no levels");
  }
  s.seeds = json.at("seeds").get<std::vector<std::uint64_t>>();
  s.measures = json.at("measures").get<std::vector<std::string>>();
  for (const std::string& name : s.measures)
    if (!findStudyMeasure(name)) throw FileError("this build knows no measure '" + name + "'");
  s.when = {choiceOf<Moments>(json.at("when")), json.at("every").get<double>()};
  const Json &keep = json.at("keep"), &limits = json.at("limits");
  s.keep = {choiceOf<HashesKept>(keep.at("hashes")), choiceOf<SamplesKept>(keep.at("samples")),
            choiceOf<PicturesKept>(keep.at("pictures"))};
  if (!limits.at("cpu_per_run").is_null()) s.limits.cpu = limits.at("cpu_per_run").get<double>();
  if (!limits.at("memory_per_run").is_null())
    s.limits.memory = limits.at("memory_per_run").get<std::uint64_t>();
  if (s.seeds.empty() || s.bases.empty()) throw FileError("there are no seeds or no scenarios");
  return s;
}

NamedFile fileOf(const Json& files, const Json& number) {
  const Json& file = files.at(number.get<std::size_t>());
  return {file.at("role").get<std::string>(), file.at("path").get<std::string>(), file.at("text").get<std::string>()};
}

Plan planOf(const Json& json) {
  Plan plan;
  plan.study = studyOf(json.at("study"));
  const Json &conditions = json.at("conditions"), &files = json.at("files");
  if (conditions.size() != study::countConditions(plan.study)) throw FileError("it lacks conditions");
  for (const Json& c : conditions) {
    Condition& condition =
        plan.conditions.emplace_back(study::conditionOf(plan.study, plan.conditions.size()));
    const NamedFile base = fileOf(files, c.at("scenario"));
    std::vector<NamedFile> named;
    for (const Json& number : c.at("files")) named.push_back(fileOf(files, number));
    condition.scenario =
        study::readConditionScenario(plan.study, condition, base.content, base.path, "", named);
    condition.scenario.warnings.clear();
    study::finish(condition, plan.study);
    if (condition.meaning.text() != c.at("meaning").get<std::string>())
      throw FileError("its condition " + nameOf(plan, condition.number) +
                      " means something else to this build of Morula than to the one that made the plan");
  }
  study::addTasks(plan);
  for (const Json& c : json.at("costs"))
    plan.costs.push_back({c.at("cpu_seconds").get<double>(), c.at("memory").get<double>(),
                          c.at("disk").get<double>(), c.at("tried").get<bool>()});
  if (!plan.costs.empty() && plan.costs.size() != plan.conditions.size()) throw FileError("it lacks costs");
  plan.id = study::planId(plan);
  if (plan.id != json.at("id").get<std::string>() || membersOf(plan) != json)
    throw FileError("it means something else to this build of Morula than to the one that made it");
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
    throw fail("is damaged: it was changed since it was made",
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
