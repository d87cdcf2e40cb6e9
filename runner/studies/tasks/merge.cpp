#include "tasks/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "database/store_error.h"
#include "files/draft.h"
#include "files/folders.h"
#include "files/text.h"
#include "simulation/memory.h"
#include "study/plan.h"
#include "study_store/merged_study.h"
#include "system/clock.h"
#include "system/json.h"

namespace morula {
namespace {

/// Returns the changes of a level, key by key, as texts of the study file.
std::string keysOf(const Level& level) {
  Json keys = Json::object();
  for (const Override& o : level.overrides) keys[o.path] = o.removes ? Json() : Json(o.value);
  return jsonText(keys);
}

/// Returns all keys that some level changes, in the order of the file.
std::vector<std::string> changedKeys(const Study& study) {
  std::vector<std::string> keys;
  for (const StudyAxis& axis : study.axes)
    for (const Level& level : axis.levels)
      for (const Override& o : level.overrides)
        if (std::ranges::find(keys, o.path) == keys.end()) keys.push_back(o.path);
  return keys;
}

/// Makes names of columns unique, also without regard to capitals.
std::vector<std::string> asColumns(std::vector<std::string> names, std::vector<std::string> taken) {
  for (std::string& name : names) {
    while (std::ranges::any_of(taken, [&](const std::string& other) { return equalButForCase(other, name); }))
      name += "_";
    taken.push_back(name);
  }
  return names;
}

/// Returns the value at "division.plane" of the resolved scenario; texts as they are, others as JSON. Absent if the
/// scene has no such part.
std::optional<std::string> valueAt(const Json& resolved, const std::string& path) {
  const Json* value = &resolved;
  for (const std::string& key : partsOf(path, '.')) {
    if (!value->contains(key)) return std::nullopt;
    value = &value->at(key);
  }
  return value->is_string() ? value->get<std::string>() : jsonText(*value);
}

StudyTables::ConditionRow rowOf(const Plan& plan, const Condition& condition, const std::vector<std::string>& keys) {
  StudyTables::ConditionRow row{.labels = condition.labels, .usesSeed = condition.usesSeed};
  const Json resolved = parseJson(condition.scenario.resolved);
  for (const std::string& key : keys) row.keyValues.push_back(valueAt(resolved, key));
  std::set<std::size_t> runs;
  for (const Replicate& r : plan.replicates)
    if (r.condition == condition.number) runs.insert(r.task);
  row.distinctRuns = runs.size();
  return row;
}

StudyTables tablesOf(const Plan& plan) {
  const Study& study = plan.study;
  Plan withoutCosts = plan;
  withoutCosts.costs.clear();  // costs depend on the machine that made the plan
  StudyTables tables{.study = {study.name, study.summary, plan.id, writePlan(withoutCosts), {}}};
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

namespace fs = std::filesystem;

/// Returns the tasks' files in a folder, which is a study's folder or holds the files itself.
std::vector<fs::path> filesIn(const fs::path& folder) {
  const fs::path tasks = isFolder(folder / "tasks") ? folder / "tasks" : folder;
  std::vector<fs::path> files;
  for (const fs::path& name : namesIn(tasks)) {
    const std::string id = name.stem().string();
    const bool isTask = id.size() == 16 && id.find_first_not_of("0123456789abcdef") == id.npos;
    if (isTask && name.extension() == ".db") files.push_back(tasks / name);
  }
  return files;
}

/// Returns the resolved scenario with another seed, by its line in the text: scenarioOf takes long.
std::string resolvedWithSeed(const Scenario& scenario, std::uint64_t seed) {
  std::string text = scenario.resolved;
  const std::string before = fmt::format("\n  \"seed\": {}", scenario.scene.seed);
  const auto at = text.find(before);
  MORULA_CHECK(at != text.npos, "a resolved scenario has its seed on a line of its own");
  return text.replace(at, before.size(), fmt::format("\n  \"seed\": {}", seed));
}

/// Finds the files of each task; files whose names do not tell their task are opened.
class Sources {
 public:
  Sources(const PlannedStudy& study, const MergeOptions& options, MergeReport& report)
      : report_(report), files_(study.plan.tasks.size()) {
    for (std::size_t t = 0; t < study.plan.tasks.size(); ++t) numbers_[study.plan.tasks[t].id] = t;
    if (isFolder(study.folder.tasks())) addFolder(study.folder.tasks());
    for (const std::string& shard : options.shards) {
      if (isFolder(shard)) addFolder(shard);
      else addFile(shard, TaskFile(shard).task().id);
    }
  }

  const std::vector<fs::path>& of(std::size_t task) const { return files_[task]; }

 private:
  void addFolder(const fs::path& folder) {
    for (const fs::path& file : filesIn(folder)) addFile(file, file.stem().string());
  }

  void addFile(const fs::path& file, const std::string& id) {
    const auto number = numbers_.find(id);
    if (number == numbers_.end()) report_.foreign.push_back({file, "the plan has no such task"});
    else if (seen_.insert(absolutePath(file)).second) files_[number->second].push_back(file);
  }

  MergeReport& report_;
  std::map<std::string, std::size_t> numbers_;
  std::set<fs::path> seen_;
  std::vector<std::vector<fs::path>> files_;  // [task]
};

class Merge {
 public:
  Merge(const PlannedStudy& study, const MergeOptions& options) : study_(study), options_(options) {}

  MergeReport run() {
    const double begun = seconds(ClockKind::wall);
    const Plan& plan = study_.plan;
    report_.database = options_.output;
    report_.tasks = plan.tasks.size();
    const Sources sources(study_, options_, report_);
    const StudyTables tables = tablesOf(plan);
    makeFolder(options_.output.parent_path());
    removeAbandonedDrafts(options_.output.parent_path());
    MergedStudy merged(options_.output, tables);
    for (std::size_t task = 0; task < plan.tasks.size(); ++task) {
      const Task& t = plan.tasks[task];
      const TaskRow planned{.id = t.id, .number = task, .condition = t.condition, .seed = t.seed};
      if (auto chosen = choose(task, sources.of(task))) {
        note(task, *chosen);
        merged.add(planned, *chosen);
      } else {
        report_.missing.push_back(task);
        merged.addMissing(planned);
      }
    }
    if (report_.differing.empty()) {
      merged.finish(tables, build_);
      report_.bytes = fileSize(options_.output);
    }
    report_.seconds = seconds(ClockKind::wall) - begun;
    return std::move(report_);
  }

 private:
  /// Returns the whole file of a task. A result that was computed comes before a failure by the machine's limits; among
  /// equals the least hash comes first, so that the order of files decides nothing.
  std::optional<TaskFile> choose(std::size_t task, const std::vector<fs::path>& files) {
    std::optional<TaskFile> chosen;
    fs::path from;
    for (const fs::path& file : files) {
      std::optional<TaskFile> found = verified(task, file);
      if (!found) continue;
      if (chosen && chosen->task().isComputed() && found->task().isComputed() &&
          chosen->task().resultHash != found->task().resultHash)
        report_.differing.push_back({task, from, file, chosen->task().resultHash, found->task().resultHash});
      if (!chosen || comesBefore(found->task(), chosen->task())) chosen = std::move(found), from = file;
    }
    return chosen;
  }

  static bool comesBefore(const TaskRow& a, const TaskRow& b) {
    return std::tuple(!a.isComputed(), a.resultHash) < std::tuple(!b.isComputed(), b.resultHash);
  }

  std::optional<TaskFile> verified(std::size_t task, const fs::path& file) {
    try {
      TaskFile found(file);
      std::string wrong = found.whatIsWrong();
      if (wrong.empty()) wrong = differsFromPlan(task, found);
      if (wrong.empty()) {
        requireOneBuild(found, file);
        return found;
      }
      report_.damaged.push_back({file, wrong});
    } catch (const StoreError& error) { report_.damaged.push_back({file, error.what()}); }
    return std::nullopt;
  }

  std::string differsFromPlan(std::size_t task, TaskFile& found) const {
    const Task& planned = study_.plan.tasks[task];
    if (found.task().id != planned.id)
      return "the file is named after task " + planned.id + ", but holds task " + found.task().id;
    const Condition& condition = study_.plan.conditions[planned.condition];
    // If no seed changes anything, the file's plan may have begun with another seed.
    const std::uint64_t seed = condition.usesSeed ? planned.seed : found.run().record.seed;
    if (found.run().record.seed != seed || found.resolved() != resolvedWithSeed(condition.scenario, seed))
      return "its run has another scene or seed than the plan's task " + planned.id;
    return "";
  }

  void requireOneBuild(TaskFile& found, const fs::path& file) {
    const std::string build = found.buildId();
    if (build_.empty()) build_ = build, firstOfBuild_ = file;
    if (build == build_) return;
    throw FileError("'" + firstOfBuild_.string() + "' and '" + file.string() +
                    "' were computed by different builds of the program (" + build_ + " and " + build +
                    "), so they cannot be compared; run one of them again with the other's");
  }

  void note(std::size_t task, TaskFile& file) {
    if (file.task().status == TaskStatus::done) ++report_.done;
    else report_.failed.push_back({task, file.task().reason});
    if (std::string why = file.whyInsane(); !why.empty()) report_.insane.push_back({task, std::move(why)});
  }

  const PlannedStudy& study_;
  const MergeOptions& options_;
  MergeReport report_;
  std::string build_;
  fs::path firstOfBuild_;
};

std::string fileLines(const std::vector<RefusedFile>& files) {
  std::vector<std::string> lines;
  for (const RefusedFile& f : files) lines.push_back("  left out " + f.file.string() + ": " + f.why);
  return firstOf(lines);
}

}  // namespace

MergeReport mergeStudy(const PlannedStudy& study, const MergeOptions& options) { return Merge(study, options).run(); }

StateCounts MergeReport::counts() const {
  StateCounts counts;
  counts.add(ResultState::fine, done - insane.size());
  counts.add(ResultState::insane, insane.size());
  counts.add(ResultState::failed, failed.size());
  counts.add(ResultState::missing, missing.size());
  counts.add(ResultState::changed, damaged.size());
  return counts;
}

std::string describe(const MergeReport& r, const PlannedStudy& study) {
  const Plan& plan = study.plan;
  std::string text = fmt::format("{}: {} runs: {}, {} failed, {} missing\n", plan.study.name, r.tasks,
                                 doneInWords(r.done, r.insane.size()), r.failed.size(), r.missing.size());
  text += taskLines("  failed   ", r.failed, plan);
  text += taskLines("  not sane ", r.insane, plan);
  text += taskLines("  missing  ", r.missing, plan) + fileLines(r.damaged) + fileLines(r.foreign);
  for (const Nondeterminism& n : r.differing)
    text += fmt::format(
        "  NONDETERMINISM {}: the same scenario, seed and build gave two results: {} in {}, {} in {}. This is a bug or "
        "broken hardware; nothing was written\n",
        nameOfTask(plan, n.task), n.hashA, n.a.string(), n.hashB, n.b.string());
  if (r.differing.empty())
    text += fmt::format("  results  {} ({})\n", r.database.string(), bytesText(static_cast<double>(r.bytes)));
  return text;
}

Json toJson(const MergeReport& r, const PlannedStudy& study) {
  const Plan& plan = study.plan;
  Json leftOut = Json::array(), differing = Json::array();
  for (const auto* files : {&r.damaged, &r.foreign})
    for (const RefusedFile& f : *files) leftOut.push_back({{"file", f.file.string()}, {"why", f.why}});
  for (const Nondeterminism& n : r.differing) {
    differing.push_back(toJson(std::vector{n.task}, plan)[0]);
    differing.back().update(Json{{"files", {n.a.string(), n.b.string()}}, {"result_hashes", {n.hashA, n.hashB}}});
  }
  return {{"study", plan.study.name},
          {"plan_id", plan.id},
          {"tasks", r.tasks},
          {"done", r.done},
          {"failed", toJson(r.failed, plan)},
          {"missing", toJson(r.missing, plan)},
          {"not_sane", toJson(r.insane, plan)},
          {"states", r.counts().json()},
          {"left_out", leftOut},
          {"nondeterminism", differing},
          {"db", r.differing.empty() ? Json(r.database.string()) : Json()},
          {"bytes", r.bytes},
          {"seconds", r.seconds}};
}

}  // namespace morula
