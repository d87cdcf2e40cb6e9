#include "analysis/study_results.h"

#include <algorithm>
#include <map>

#include "analysis/measure_words.h"
#include "database/database.h"
#include "database/store_error.h"
#include "files/text.h"
#include "store/result_file.h"
#include "store/seal.h"
#include "study/study_file.h"
#include "study_store/study_tables.h"

namespace morula {
namespace {

[[noreturn]] void damaged(Database& db, const std::string& what) {
  throw StoreError(db.file().string() + ": " + what + "; the file is damaged: make it again with morula study merge");
}

void readAxes(Database& db, StudyResults& results) {
  Statement axes(db, "SELECT number, name FROM axis ORDER BY number");
  for (axes.start(); axes.next();) {
    ResultAxis& axis = results.axes.emplace_back(ResultAxis{axes.line(1), {}});
    Statement levels(db, "SELECT label FROM level WHERE axis = ? ORDER BY number");
    for (levels.start(axes.integer(0)); levels.next();) axis.labels.push_back(levels.line(0));
    if (axis.labels.empty()) damaged(db, "the axis '" + axis.name + "' has no levels");
  }
}

/// Returns the number of each condition by its id.
std::map<std::int64_t, std::size_t> readConditions(Database& db, StudyResults& results) {
  std::string columns = "condition_id, uses_seed";
  for (const ResultAxis& axis : results.axes) columns += ", " + sqlName(axis.name);
  std::map<std::int64_t, std::size_t> numbers;
  Statement rows(db, "SELECT " + columns + " FROM condition ORDER BY condition_id");
  for (rows.start(); rows.next();) {
    ResultCondition condition;
    condition.usesSeed = rows.integer(1) != 0;
    for (std::size_t a = 0; a < results.axes.size(); ++a) {
      const auto& labels = results.axes[a].labels;
      const auto at = std::ranges::find(labels, rows.line(static_cast<int>(a) + 2));
      if (at == labels.end()) damaged(db, "a condition has a label that its axis lacks");
      condition.levels.push_back(static_cast<std::size_t>(at - labels.begin()));
    }
    numbers[rows.integer(0)] = results.conditions.size();
    results.conditions.push_back(std::move(condition));
  }
  return numbers;
}

/// Returns the number of each task by its id.
std::map<std::string, std::size_t> readTasks(Database& db, StudyResults& results) {
  std::map<std::string, std::size_t> numbers;
  Statement rows(db,
                 "SELECT task_id, task.status, reason, run_id, run.state_hash, (SELECT count(*) FROM check_result c "
                 "WHERE c.run_id = task.run_id AND kind = 'sanity' AND NOT passed), "
                 "CASE task.status WHEN 'done' THEN coalesce(run.cells, 0) ELSE 0 END FROM task "
                 "LEFT JOIN run USING (run_id) ORDER BY number, task_id");
  for (rows.start(); rows.next();) {
    numbers[rows.text(0)] = results.tasks.size();
    results.tasks.push_back({rows.line(0), rows.choice<TaskStatus>(1), rows.line(2), rows.line(3), rows.line(4),
                             std::vector<std::vector<TimedValue>>(results.measures.size()),
                             static_cast<std::size_t>(rows.integer(6)), rows.integer(5) == 0});
  }
  return numbers;
}

/// Reads the reasons for which ends are not sane.
void readInsanity(Database& db, StudyResults& results) {
  std::map<std::string, std::vector<CheckResult>> checks;  // by run
  Statement rows(db,
                 "SELECT run_id, field, actual, expected, cell FROM check_result WHERE kind = 'sanity' AND NOT passed "
                 "ORDER BY run_id, \"check\"");
  for (rows.start(); rows.next();)
    checks[rows.line(0)].push_back({.kind = CheckKind::sanity,
                                    .expected = rows.line(3),
                                    .actual = rows.line(2),
                                    .passed = false,
                                    .cell = rows.isNull(4) ? std::nullopt : std::optional(rows.line(4)),
                                    .field = rows.line(1)});
  for (ResultTask& task : results.tasks)
    if (!task.isSane) task.reason = whyInsane(checks[task.runId]);
}

void readReplicates(Database& db, const std::map<std::int64_t, std::size_t>& conditions,
                    const std::map<std::string, std::size_t>& tasks, StudyResults& results) {
  struct Row {
    std::size_t condition, task;
    std::uint64_t seed;
  };
  std::vector<Row> all;
  Statement rows(db, "SELECT condition_id, seed, task_id FROM replicate");
  for (rows.start(); rows.next();) {
    const auto condition = conditions.find(rows.integer(0));
    const auto task = tasks.find(rows.text(2));
    if (condition == conditions.end() || task == tasks.end())
      damaged(db, "a replicate names a condition or a task that does not exist");
    all.push_back({condition->second, task->second, rows.bits(1)});
    results.seeds.push_back(all.back().seed);
  }
  std::ranges::sort(results.seeds);
  results.seeds.erase(std::unique(results.seeds.begin(), results.seeds.end()), results.seeds.end());
  for (ResultCondition& c : results.conditions) c.tasks.assign(results.seeds.size(), noTask);
  for (const Row& row : all) {
    const auto seed = std::ranges::lower_bound(results.seeds, row.seed) - results.seeds.begin();
    results.conditions[row.condition].tasks[static_cast<std::size_t>(seed)] = row.task;
  }
}

/// Reads the measures that the plan asks for, in its order, including those without values.
void readMeasures(Database& db, const std::string& plan, StudyResults& results) {
  const Json json = tryParseJson(plan);
  if (json.is_object() && json.contains("study") && json["study"].contains("measures"))
    for (const Json& name : json["study"]["measures"])
      if (name.is_string()) results.measures.push_back(name.get<std::string>());
  const std::size_t planned = results.measures.size();
  Statement rows(db, "SELECT DISTINCT measure FROM result ORDER BY measure");
  for (rows.start(); rows.next();)
    if (const std::string name = rows.line(0); std::ranges::find(results.measures, name) == results.measures.end())
      results.measures.push_back(name);
  std::stable_sort(results.measures.begin() + static_cast<std::ptrdiff_t>(planned), results.measures.end(),
                   [](const std::string& a, const std::string& b) { return placeOfMeasure(a) < placeOfMeasure(b); });
}

/// Reads how many failed and insane runs the study file in the plan allows.
void readAllowed(const std::string& plan, StudyResults& results) {
  const Json json = tryParseJson(plan);
  if (!json.is_object() || !json.contains("study") || !json["study"].is_object()) return;
  if (const auto text = json["study"].find("text"); text != json["study"].end() && text->is_string())
    results.allowed = allowedIn(text->get<std::string>());
}

void readValues(Database& db, const std::map<std::string, std::size_t>& tasks, StudyResults& results) {
  std::map<std::string, std::size_t> measures;
  for (std::size_t m = 0; m < results.measures.size(); ++m) measures[results.measures[m]] = m;
  Statement rows(db,
                 "SELECT task_id, measure, time, value FROM task JOIN result USING (run_id) WHERE task.status = 'done' "
                 "ORDER BY task_id, measure, time");
  for (rows.start(); rows.next();)
    results.tasks[tasks.at(rows.text(0))].values[measures.at(rows.line(1))].push_back({rows.real(2), rows.real(3)});
}

}  // namespace

ResultState ResultTask::state() const {
  if (status != TaskStatus::done) return status == TaskStatus::failed ? ResultState::failed : ResultState::missing;
  return isSane ? ResultState::fine : ResultState::insane;
}

StateCounts StudyResults::counts() const {
  StateCounts counts;
  for (const ResultTask& task : tasks) counts.add(task.state());
  return counts;
}

bool StudyResults::isDone(std::size_t task) const { return task != noTask && tasks[task].status == TaskStatus::done; }

std::optional<double> StudyResults::end(std::size_t measure, std::size_t task) const {
  if (task == noTask || tasks[task].values[measure].empty()) return std::nullopt;
  return tasks[task].values[measure].back().value;
}

std::string StudyResults::nameOf(const ResultCondition& condition) const {
  std::vector<std::string> labels;
  for (std::size_t a = 0; a < axes.size(); ++a) labels.push_back(axes[a].labels[condition.levels[a]]);
  return labels.empty() ? "the scenario as it is" : join(labels);
}

std::vector<TroubledRun> troubledRuns(const StudyResults& results) {
  std::vector<TroubledRun> runs;
  std::vector<bool> told(results.tasks.size());
  for (const ResultCondition& condition : results.conditions)
    for (std::size_t s = 0; s < results.seeds.size(); ++s) {
      const std::size_t t = condition.tasks[s];
      if (t == noTask || told[t] || (results.tasks[t].status == TaskStatus::done && results.tasks[t].isSane)) continue;
      told[t] = true;
      runs.push_back({results.nameOf(condition), results.seeds[s], results.tasks[t]});
    }
  return runs;
}

std::vector<std::vector<std::string>> namesOfSameRuns(const StudyResults& results) {
  std::map<std::vector<std::size_t>, std::vector<std::string>> byTasks;
  for (const ResultCondition& condition : results.conditions)
    byTasks[condition.tasks].push_back(results.nameOf(condition));
  std::vector<std::vector<std::string>> same;
  for (auto& [tasks, names] : byTasks)
    if (names.size() > 1) same.push_back(std::move(names));
  return same;
}

void requireIntactStudy(const std::filesystem::path& file) {
  Database db(file, Database::Mode::existing, std::chrono::seconds(5));
  if (db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('study', 'replicate')") > 0)
    requireSealedStudy(db);
}

void readStoredPlan(const std::filesystem::path& file, const std::function<void(const Json&)>& read) {
  Database db(file, Database::Mode::existing, std::chrono::seconds(5));
  requireSealedStudy(db);
  Statement rows(db, "SELECT plan FROM study");
  try {
    if (rows.start().next()) return read(parseJson(rows.text(0)));
  } catch (const Json::exception&) {}
  damaged(db, "the study's plan cannot be read");
}

StudyResults readStudyResults(const std::filesystem::path& file) {
  Database db(file, Database::Mode::existing, std::chrono::seconds(5));
  requireTables(db);
  if (db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('study', 'replicate')") < 2)
    throw StoreError(file.string() +
                     ": a database of runs, but of no study; give the study.db that morula study merge makes");
  requireSealedStudy(db);
  requireAllSealed(db, [](TablePart part) {
    return part == TablePart::record || part == TablePart::checks || part == TablePart::study;
  });
  StudyResults results;
  Statement study(db, "SELECT name, summary, plan, build_id FROM study");
  if (!study.start().next()) damaged(db, "the table study is empty");
  results.name = study.line(0), results.summary = study.line(1), results.buildId = study.text(3);
  readMeasures(db, study.text(2), results);
  readAllowed(study.text(2), results);
  readAxes(db, results);
  const auto conditions = readConditions(db, results);
  const auto tasks = readTasks(db, results);
  readInsanity(db, results);
  readReplicates(db, conditions, tasks, results);
  readValues(db, tasks, results);
  return results;
}

}  // namespace morula
