#include "study_store/study_tables.h"

#include <array>

#include "base/error.h"
#include "database/measure_columns.h"
#include "database/store_error.h"

namespace morula {

namespace {

// Keys that are texts of the plan's own making stand first, as in database/schema.cpp.
const char* const taskTables = R"sql(
CREATE TABLE task (
  task_id      TEXT NOT NULL,        -- from the scene's meaning, the seed if it is used, measures, when and keep
  number       INTEGER NOT NULL,     -- in the plan
  condition_id INTEGER NOT NULL,     -- of the first replicate that needs it
  seed         INTEGER NOT NULL,     -- of that replicate; two's complement from 2^63 on
  status       TEXT NOT NULL CHECK (status = 'done' OR status = 'failed' OR status = 'missing'),
  reason       TEXT NOT NULL,        -- 'numerical failure: …', 'cpu limit: …', 'memory limit: …', 'crash: …'; '' unless failed
  run_id       TEXT REFERENCES run ON DELETE CASCADE,  -- NULL while it is missing
  result_hash  TEXT,                 -- over all results of the run; NULL while it is missing
  PRIMARY KEY (task_id)
) STRICT, WITHOUT ROWID;

CREATE TABLE result (                -- a measure of the world; of cells, the mean over the living; of pairs, over those that touch
  run_id  TEXT NOT NULL REFERENCES run ON DELETE CASCADE,
  measure TEXT NOT NULL,
  time    REAL NOT NULL,             -- the last is the end
  value   REAL NOT NULL,
  PRIMARY KEY (run_id, measure, time)
) STRICT, WITHOUT ROWID;

CREATE TABLE timing (                -- when and where: the only table in which two runs of a study may differ
  task_id        TEXT NOT NULL,
  started        TEXT NOT NULL,      -- UTC
  ended          TEXT NOT NULL,
  cpu_seconds    REAL NOT NULL,
  max_memory     INTEGER NOT NULL,   -- bytes
  host           TEXT NOT NULL,
  cpu            TEXT NOT NULL,
  kernel         TEXT NOT NULL,
  cpu_features   TEXT NOT NULL,
  fp_environment TEXT NOT NULL,
  isa            TEXT NOT NULL,
  threads        INTEGER NOT NULL,
  command        TEXT NOT NULL,
  binary_hash    TEXT NOT NULL,
  PRIMARY KEY (task_id)
) STRICT, WITHOUT ROWID;
)sql";

const char* const studyTables = R"sql(
CREATE TABLE study (                 -- one row
  name     TEXT NOT NULL,
  summary  TEXT NOT NULL,
  plan_id  TEXT NOT NULL,
  plan     TEXT NOT NULL,            -- the plan's file without what it predicts
  build_id TEXT NOT NULL             -- of the program that computed all tasks; '' if there is none yet
) STRICT;

CREATE TABLE axis (
  number INTEGER NOT NULL,           -- in the order of the study file
  name   TEXT NOT NULL,
  PRIMARY KEY (number)
) STRICT, WITHOUT ROWID;

CREATE TABLE level (
  axis   INTEGER NOT NULL REFERENCES axis,
  number INTEGER NOT NULL,           -- in the order of the study file
  label  TEXT NOT NULL,
  keys   TEXT NOT NULL,              -- JSON: what it changes in the scenario; null takes a part away
  PRIMARY KEY (axis, number)
) STRICT, WITHOUT ROWID;

CREATE TABLE replicate (             -- each run that the design asks for
  condition_id INTEGER NOT NULL REFERENCES condition,
  seed         INTEGER NOT NULL,
  task_id      TEXT NOT NULL REFERENCES task,  -- replicates that would be the same run share one
  PRIMARY KEY (condition_id, seed)
) STRICT, WITHOUT ROWID;
)sql";

std::string columnsOfTexts(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += ",\n  " + quotedName(name) + " TEXT";
  return text;
}

std::vector<std::string> columnsOfTable(Database& db, const std::string& table) {
  std::vector<std::string> names;
  Statement s(db, "SELECT name FROM pragma_table_info(?)");
  for (s.start(table); s.next();) names.push_back(s.text(0));
  return names;
}

/// All rows of the statement, one after the other.
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

const char* name(FailureKind kind) {
  switch (kind) {
    case FailureKind::numerical:
      return "numerical failure";
    case FailureKind::cpuLimit:
      return "cpu limit";
    case FailureKind::memoryLimit:
      return "memory limit";
    case FailureKind::crash:
      return "crash";
  }
  throw BugError("a kind of failure that is not one");
}

bool TaskRow::isComputed() const {
  return status == "done" || (status == "failed" && reason.starts_with(name(FailureKind::numerical)));
}

void makeTaskTables(Database& db) { db.execute(taskTables); }

void makeStudyTables(Database& db, const std::vector<std::string>& axes,
                     const std::vector<std::string>& keys) {
  db.execute(
      "CREATE TABLE condition (            -- one cell of the factorial design; a column an axis: its label\n"
      "  condition_id INTEGER PRIMARY KEY" +
      columnsOfTexts(axes) +
      ",\n  uses_seed INTEGER NOT NULL,     -- 0: every seed gives the same run"
      "\n  distinct_runs INTEGER NOT NULL  -- of its replicates\n) STRICT");
  db.execute(
      "CREATE TABLE condition_key (        -- a column for each key of the scenario that some level changes: "
      "its value as "
      "JSON; NULL: the scene has no such part\n"
      "  condition_id INTEGER PRIMARY KEY REFERENCES condition" +
      columnsOfTexts(keys) + "\n) STRICT");
  db.execute(studyTables);
}

void insertTask(Database& db, const TaskRow& t) {
  const auto orNull = [](const std::string& text) {
    return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
  };
  Statement(db,
            insertInto("task", "task_id, number, condition_id, seed, status, reason, run_id, result_hash"))
      .run(t.id, t.number, t.condition, t.seed, t.status, t.reason, orNull(t.runId), orNull(t.resultHash));
}

void insertResults(Database& db, const std::string& run, const std::vector<ResultRow>& results) {
  Statement insert(db, insertInto("result", "run_id, measure, time, value"));
  for (const ResultRow& r : results) insert.run(run, r.measure, r.time, r.value);
}

void insertTiming(Database& db, const std::string& task, const TimingRow& t) {
  Statement(db,
            insertInto("timing",
                       "task_id, started, ended, cpu_seconds, max_memory, host, cpu, kernel, cpu_features, "
                       "fp_environment, isa, threads, command, binary_hash"))
      .run(task, t.started, t.ended, t.cpuSeconds, t.maxMemory, t.host, t.cpu, t.kernel, t.cpuFeatures,
           t.fpEnvironment, t.isa, t.threads, t.command, t.binaryHash);
}

const std::vector<std::string>& tablesOfResults() {
  static const std::vector<std::string> tables{
      "cell",     "sample",    "cell_sample", "contact",      "measure", "connection", "time_step",
      "division", "step_hash", "cell_hash",   "check_result", "result",  "mesh_sample"};
  return tables;
}

Hash resultHash(Database& db, const std::string& run) {
  Hasher hasher;
  Statement end(
      db,
      "SELECT run_id, scenario_hash, status, state_hash, steps, cells, time, failure FROM run WHERE "
      "run_id = ?");
  end.start(run);
  hasher.field("run");
  addRows(hasher, end,
          {"run_id", "scenario_hash", "status", "state_hash", "steps", "cells", "time", "failure"});
  for (const std::string& table : tablesOfResults()) {
    // Each row in the order of its key: the tables have no other.
    std::vector<std::string> columns = columnsOfTable(db, table);
    std::string list;
    for (const std::string& column : columns) list += (list.empty() ? "" : ", ") + quotedName(column);
    Statement rows(db, "SELECT " + list + " FROM " + quotedName(table) + " WHERE run_id = ?");
    rows.start(run);
    hasher.field(table);
    addRows(hasher, rows, columns);
  }
  return hasher.digest();
}

std::string quotedName(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

}  // namespace morula
