#include "tasks/study_rows.h"

#include <algorithm>
#include <set>

#include "system/json.h"

namespace morula {
namespace {

/// What a level changes, key by key: the texts of the study file.
std::string keysOf(const Level& level) {
  Json keys = Json::object();
  for (const Override& o : level.overrides) keys[o.path] = o.removes ? Json() : Json(o.value);
  return jsonText(keys);
}

/// All keys that some level changes, in the order of the file.
std::vector<std::string> changedKeys(const Study& study) {
  std::vector<std::string> keys;
  for (const StudyAxis& axis : study.axes)
    for (const Level& level : axis.levels)
      for (const Override& o : level.overrides)
        if (std::ranges::find(keys, o.path) == keys.end()) keys.push_back(o.path);
  return keys;
}

/// Two columns may not have names that are the same but for capitals.
std::vector<std::string> asColumns(std::vector<std::string> names, std::set<std::string> taken) {
  const auto small = [](std::string text) {
    for (char& c : text)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
  };
  for (std::string& name : names) {
    while (!taken.insert(small(name)).second) name += "_";
  }
  return names;
}

/// The value at "division.plane" of the resolved scenario; texts as they are, others as JSON; absent if the scene has no
/// such part.
std::optional<std::string> valueAt(const Json& resolved, const std::string& path) {
  const Json* value = &resolved;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string key = path.substr(begin, end - begin);
    if (!value->contains(key)) return std::nullopt;
    value = &value->at(key);
    begin = end + 1;
  }
  return value->is_string() ? value->get<std::string>() : jsonText(*value);
}

StudyTables::ConditionRow rowOf(const Plan& plan, const Condition& condition, const std::vector<std::string>& keys) {
  StudyTables::ConditionRow row{
      .labels = condition.labels, .usesSeed = condition.usesSeed, .distinctRuns = 0, .keyValues = {}};
  const Json resolved = parseJson(condition.scenario.resolved);
  for (const std::string& key : keys) row.keyValues.push_back(valueAt(resolved, key));
  std::set<std::size_t> runs;
  for (const Replicate& r : plan.replicates)
    if (r.condition == condition.number) runs.insert(r.task);
  row.distinctRuns = runs.size();
  return row;
}

}  // namespace

StudyTables tablesOf(const Plan& plan) {
  const Study& study = plan.study;
  Plan withoutCosts = plan;
  withoutCosts.costs.clear();  // they are of the machine that made the plan
  StudyTables tables{.study = {study.name, study.summary, plan.id, writePlan(withoutCosts), {}},
                     .axes = {},
                     .levels = {},
                     .keys = {},
                     .conditions = {},
                     .replicates = {}};
  std::vector<std::string> names;
  for (const StudyAxis& axis : study.axes) names.push_back(axis.name);
  names = asColumns(std::move(names), {"condition_id", "uses_seed", "distinct_runs"});
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    tables.axes.push_back({a, names[a]});
    std::uint64_t number = 0;
    for (const Level& level : study.axes[a].levels) tables.levels.push_back({a, number++, level.label, keysOf(level)});
  }
  const std::vector<std::string> keys = changedKeys(study);
  tables.keys = asColumns(keys, {"condition_id"});
  for (const Condition& condition : plan.conditions) tables.conditions.push_back(rowOf(plan, condition, keys));
  for (const Replicate& r : plan.replicates) tables.replicates.push_back({r.condition, r.seed, plan.tasks[r.task].id});
  return tables;
}

}  // namespace morula
