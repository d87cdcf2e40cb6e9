#include "study_store/study_tables.h"

#include <algorithm>

#include "base/error.h"
#include "database/store_error.h"
#include "store/run_tables.h"

namespace morula {
namespace {

std::string columnsOfTexts(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += ",\n  " + sqlName(name) + " TEXT";
  return text;
}

/// Hashes all rows of the statement.
void addRows(Hasher& hasher, Statement& rows, const std::vector<std::string>& columns) {
  while (rows.next()) {
    hasher.field("row");
    for (int i = 0; i < static_cast<int>(columns.size()); ++i) {
      if (rows.isNull(i)) continue;
      hasher.field(columns[static_cast<std::size_t>(i)]);
      rows.addTo(hasher, i);
    }
  }
}

}  // namespace

std::string reasonOf(FailureKind kind, const std::string& why) { return nameOf(kind) + (": " + why); }

bool TaskRow::isComputed() const {
  return status == TaskStatus::done ||
         (status == TaskStatus::failed && reason.starts_with(nameOf(FailureKind::numerical)));
}

void makeTaskTables(Database& db, bool withComments) {
  for (const SqlTable* t : {&sqlTable<TaskRow>(), &sqlTable<ResultRow>(), &sqlTable<TimingRow>()})
    db.execute(t->create(withComments));
}

void makeStudyTables(Database& db, const std::vector<std::string>& axes, const std::vector<std::string>& keys) {
  db.execute(
      "CREATE TABLE condition (            -- one cell of the factorial design; a column an axis: its label\n"
      "  condition_id INTEGER PRIMARY KEY" +
      columnsOfTexts(axes) +
      ",\n  uses_seed INTEGER NOT NULL,     -- 0: every seed gives the same run"
      "\n  distinct_runs INTEGER NOT NULL  -- of its replicates\n) STRICT");
  db.execute(
      "CREATE TABLE condition_key (        -- a column for each key of the scenario that some level changes: its value "
      "as JSON; NULL: the scene has no such part\n"
      "  condition_id INTEGER PRIMARY KEY REFERENCES condition" +
      columnsOfTexts(keys) + "\n) STRICT");
  for (const SqlTable* t : {&sqlTable<StudyRow>(), &sqlTable<AxisRow>(), &sqlTable<LevelRow>(),
                            &sqlTable<ReplicateRow>(), &sqlTable<StudySeal>()})
    db.execute(t->create());
}

namespace {

/// The tables whose rows belong to the study and to no run; not `timing`, since times may differ and decide nothing.
const std::vector<std::string> ownTables{"study", "axis", "level", "condition", "condition_key", "replicate", "task"};

}  // namespace

void sealStudy(Database& db) {
  Statement insert(db, sqlTable<StudySeal>().insert());
  for (const std::string& table : ownTables) insert.run(StudySeal{table, digestRows(db, table, "")});
}

void requireSealedStudy(Database& db) {
  const auto sealed = rowsOf<StudySeal>(db, "");
  for (const std::string& table : ownTables) {
    const auto stored = std::ranges::find(sealed, table, &StudySeal::table);
    if (stored == sealed.end() || stored->digest != digestRows(db, table, ""))
      throw StoreError(db.file().string() + ": rows of the study's table " + table +
                       " were changed, added or lost since they were stored; restore the file from a copy, or make it "
                       "again with morula study merge");
  }
}

const std::vector<const SqlTable*>& allTables() {
  // Columns of the design are described by their purpose.
  static const SqlTable condition{{.name = "condition",
                                   .part = TablePart::study,
                                   .csv = "conditions",
                                   .why = "of a study: each combination of levels; compare reads it"},
                                  {},
                                  {}},
      key{{.name = "condition_key",
           .part = TablePart::study,
           .why = "of a study: the conditions' values of the scenario's keys, for queries"},
          {},
          {}};
  static const std::vector<const SqlTable*> tables = [] {
    std::vector<const SqlTable*> all = runTables();
    all.insert(all.end(), {&sqlTable<StudyRow>(), &sqlTable<AxisRow>(), &sqlTable<LevelRow>(), &condition, &key,
                           &sqlTable<ReplicateRow>(), &sqlTable<TaskRow>(), &sqlTable<ResultRow>(),
                           &sqlTable<TimingRow>(), &sqlTable<StudySeal>()});
    return all;
  }();
  return tables;
}

Hash resultHash(Database& db, const std::string& run) {
  Hasher hasher;
  const auto add = [&](const char* table, const std::vector<std::string>& columns) {
    std::string list;
    for (const std::string& column : columns) list += (list.empty() ? "" : ", ") + sqlName(column);
    // Rows are read by key: tables have no other order.
    Statement rows(db, "SELECT " + list + " FROM " + sqlName(table) + " WHERE run_id = ?");
    rows.start(run);
    hasher.field(table);
    addRows(hasher, rows, columns);
  };
  add("run", {"run_id", "scenario_hash", "status", "state_hash", "steps", "cells", "time", "failure"});
  for (const SqlTable* t : allTables())
    if (isResult(t->info.part) || t == &sqlTable<ResultRow>()) add(t->info.name, columnNames(db, t->info.name));
  return hasher.digest();
}

}  // namespace morula
