#include "study_store/merged_study.h"

#include "database/measure_columns.h"
#include "database/schema.h"
#include "database/store_error.h"

namespace morula {

namespace {

/// What `run` holds of times and machines, and stands in `timing` alone here.
constexpr const char* ofMachine[] = {
    "started", "ended", "cpu", "kernel", "isa", "command", "binary_hash", "fp_environment", "cpu_features"};

std::string selectedOf(const std::string& table, const std::string& column) {
  if (table != "run") return quotedName(column);
  for (const char* name : ofMachine)
    if (column == name) return "''";
  if (column == "threads") return "1";
  if (column == "condition_id") return "NULL";
  return quotedName(column);
}

/// [SELECT from a task's file, INSERT into this one], of all columns in the order of this file.
std::pair<std::string, std::string> copyOf(Database& db, const std::string& table) {
  std::string select, columns, places;
  Statement s(db, "SELECT name FROM pragma_table_info(?)");
  for (s.start(table); s.next();) {
    const std::string column = s.text(0), comma = columns.empty() ? "" : ", ";
    select += comma + selectedOf(table, column);
    columns += comma + quotedName(column);
    places += comma + "?";
  }
  return {"SELECT " + select + " FROM " + quotedName(table),
          "INSERT " + std::string(table == "document" ? "OR IGNORE " : "") + "INTO " + quotedName(table) +
              " (" + columns + ") VALUES (" + places + ")"};
}

std::vector<std::string> axisNames(const StudyTables& study) {
  std::vector<std::string> names;
  for (const auto& axis : study.axes) names.push_back(axis.name);
  return names;
}

void insertConditions(Database& db, const StudyTables& study) {
  const auto numbered = [](const std::string& table, std::size_t columns) {
    std::string places = "?";
    for (std::size_t i = 0; i < columns; ++i) places += ", ?";
    return "INSERT INTO " + table + " VALUES (" + places + ")";
  };
  Statement condition(db, numbered("condition", study.axes.size() + 2));
  Statement key(db, numbered("condition_key", study.keys.size()));
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    const auto& row = study.conditions[i];
    condition.run(std::uint64_t{i}, Texts{{row.labels.begin(), row.labels.end()}}, row.usesSeed,
                  row.distinctRuns);
    key.run(std::uint64_t{i}, Texts{row.keyValues});
  }
}

void insertAxes(Database& db, const StudyTables& study) {
  Statement axis(db, insertInto("axis", "number, name")),
      level(db, insertInto("level", "axis, number, label, keys"));
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    axis.run(std::uint64_t{a}, study.axes[a].name);
    for (std::size_t l = 0; l < study.axes[a].levels.size(); ++l)
      level.run(std::uint64_t{a}, std::uint64_t{l}, study.axes[a].levels[l].label,
                study.axes[a].levels[l].keys);
  }
}

}  // namespace

MergedStudy::MergedStudy(const std::filesystem::path& file, const StudyTables& study)
    : draft_(file), db_(draft_.path(), Database::Mode::existing, std::chrono::seconds(1)) {
  db_.execute(
      "PRAGMA journal_mode = OFF");  // a draft that is not finished is thrown away, and has no file beside it
  migrate(db_);
  db_.execute("PRAGMA foreign_keys = ON");
  db_.execute("PRAGMA cache_size = -65536");
  db_.execute("BEGIN");
  makeTaskTables(db_);
  makeStudyTables(db_, axisNames(study), study.keys);
  insertAxes(db_, study);
  insertConditions(db_, study);
  std::vector<std::string> tables{"run", "document", "run_document"};
  tables.insert(tables.end(), tablesOfResults().begin(), tablesOfResults().end());
  tables.push_back("timing");
  for (const std::string& table : tables) {
    auto [select, insert] = copyOf(db_, table);
    copies_.push_back({std::move(select), Statement(db_, insert)});
  }
}

void MergedStudy::add(const TaskRow& planned, TaskFile& file) {
  for (Copy& copy : copies_) {
    Statement rows(file.db(), copy.select);
    while (rows.next()) copy.insert.runWith(rows);
  }
  Statement(db_, "UPDATE run SET condition_id = ? WHERE run_id = ?")
      .run(planned.condition, file.task().runId);
  TaskRow task = file.task();
  task.id = planned.id, task.number = planned.number, task.condition = planned.condition,
  task.seed = planned.seed;
  insertTask(db_, task);
}

void MergedStudy::addMissing(const TaskRow& planned) { insertTask(db_, planned); }

void MergedStudy::finish(const StudyTables& study, const std::string& buildId) {
  Statement(db_, insertInto("study", "name, summary, plan_id, plan, build_id"))
      .run(study.name, study.summary, study.planId, study.plan, buildId);
  Statement replicate(db_, insertInto("replicate", "condition_id, seed, task_id"));
  for (const auto& r : study.replicates) replicate.run(r.condition, r.seed, r.task);
  db_.execute("COMMIT");
  draft_.takePlace();
}

}  // namespace morula
