#include "study_store/merged_study.h"

#include "store/result_file.h"
#include "store/run_tables.h"
#include "store/seal.h"

namespace morula {
namespace {

/// Returns true for columns of `run` on times and machines, which are blank here: the table `timing` has them.
bool isBlank(const std::string& column) {
  return column == "binary_hash" || partOf(column) == RunPart::environment || partOf(column) == RunPart::occasion;
}

/// Returns [SELECT from a task's file, INSERT into this file] for all columns, in the order of this file.
std::pair<std::string, std::string> copyOf(Database& db, const SqlTable& table) {
  std::string select, columns, places;
  const bool ofRuns = &table == &morula::sqlTable<StoredRun>();
  for (const FileColumn& column : fileColumns(db, table.info.name)) {
    const std::string comma = columns.empty() ? "" : ", ", name = sqlName(column.name);
    select += comma + (!ofRuns || !isBlank(column.name) ? name
                       : column.name == "threads"       ? "1"
                       : column.name == "condition_id"  ? "NULL"
                       : column.type == "TEXT"          ? "''"
                                                        : "0");
    columns += comma + name;
    places += comma + "?";
  }
  const std::string of = sqlName(table.info.name);
  return {"SELECT " + select + " FROM " + of, std::string("INSERT ") +
                                                  (&table == &morula::sqlTable<StoredText>() ? "OR IGNORE " : "") +
                                                  "INTO " + of + " (" + columns + ") VALUES (" + places + ")"};
}

template <class Row>
void insertAll(Database& db, const std::vector<Row>& rows) {
  Statement insert(db, sqlTable<Row>().insert());
  for (const Row& row : rows) insert.run(row);
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
    condition.run(std::uint64_t{i}, Texts{{row.labels.begin(), row.labels.end()}}, row.usesSeed, row.distinctRuns);
    key.run(std::uint64_t{i}, Texts{row.keyValues});
  }
}

}  // namespace

MergedStudy::MergedStudy(const std::filesystem::path& file, const StudyTables& study)
    : draft_(file), db_(draft_.path(), Database::Mode::existing, std::chrono::seconds(1)) {
  db_.execute("PRAGMA journal_mode = OFF");  // an unfinished draft is thrown away, and needs no journal file
  makeTables(db_);
  db_.execute("PRAGMA foreign_keys = ON");
  db_.execute("PRAGMA cache_size = -65536");
  db_.execute("BEGIN");
  makeTaskTables(db_);
  makeStudyTables(db_, axisNames(study), study.keys);
  insertAll(db_, study.axes);
  insertAll(db_, study.levels);
  insertConditions(db_, study);
  for (const SqlTable* t : allTables()) {
    const TablePart part = t->info.part;
    if (part != TablePart::record && !isResult(part) && t != &sqlTable<ResultRow>() && t != &sqlTable<TimingRow>())
      continue;
    auto [select, insert] = copyOf(db_, *t);
    copies_.push_back({std::move(select), Statement(db_, insert), t == &sqlTable<TimingRow>()});
  }
}

void MergedStudy::add(const TaskRow& planned, TaskFile& file) {
  TaskRow task = file.task();
  // Tasks of one run differ in their pictures alone: the run's rows are stored once.
  const bool isNew = runs_.insert(task.runId).second;
  for (Copy& copy : copies_) {
    if (!isNew && !copy.isOfTask) continue;
    Statement rows(file.db(), copy.select);
    while (rows.next()) copy.insert.runWith(rows);
  }
  if (isNew) {
    Statement(db_, "UPDATE run SET condition_id = ? WHERE run_id = ?").run(planned.condition, task.runId);
    sealRun(db_, task.runId);
  }
  task.id = planned.id, task.number = planned.number, task.condition = planned.condition, task.seed = planned.seed;
  addMissing(task);
}

void MergedStudy::addMissing(const TaskRow& planned) { Statement(db_, sqlTable<TaskRow>().insert()).run(planned); }

void MergedStudy::finish(const StudyTables& study, const std::string& buildId) {
  StudyRow row = study.study;
  row.buildId = buildId;
  insertAll<StudyRow>(db_, {row});
  insertAll(db_, study.replicates);
  sealStudy(db_);
  db_.execute("COMMIT");
  draft_.takePlace();
}

}  // namespace morula
