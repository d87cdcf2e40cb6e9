// The tables as other programs see them: names, types, keys and numbers, through plain SQL.
#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/result_file.h"

using namespace morula;

namespace {

std::string first(Database& db, const std::string& sql) {
  Statement s(db, sql);
  return s.next() ? s.text(0) : "(no row)";
}

struct Filled : FinishedRun {
  Database db = database();
};

}  // namespace

TEST_CASE_METHOD(Filled, "the tables have the columns that others rely on") {
  const auto expectColumns = [&](const char* table, std::initializer_list<const char*> columns) {
    INFO(table);
    for (const char* column : columns) {
      INFO(column);
      REQUIRE(db.integer(std::string("SELECT count(*) FROM pragma_table_info('") + table + "') WHERE name = '" +
                         column + "'") == 1);
    }
    REQUIRE(db.integer(std::string("SELECT strict FROM pragma_table_list('") + table + "')") == 1);
    REQUIRE(db.integer(std::string("SELECT count(*) FROM ") + table) > 0);
  };
  expectColumns("run", {"run_id", "scenario", "seed", "status", "state_hash", "started", "ended"});
  expectColumns("cell", {"run_id", "path", "parent", "born", "ended", "fate", "state", "name"});
  expectColumns("sample", {"run_id", "time", "cells"});
  expectColumns("cell_sample",
                {"run_id", "time", "path", "volume", "area", "pressure", "x", "y", "z", "sphericity", "neighbours"});
  expectColumns("contact", {"run_id", "time", "a", "b", "area"});
  expectColumns("connection", {"run_id", "a", "b", "made", "released", "cause"});
  expectColumns("check_result", {"run_id", "check", "kind", "expected", "actual", "tolerance", "passed"});
  expectColumns("division", {"run_id", "path", "time", "axis_x", "axis_y", "axis_z", "share", "extent_ratio"});
  expectColumns("step_hash", {"run_id", "step", "hash"});
  expectColumns("time_step", {"run_id", "step", "time", "time_step"});
}

TEST_CASE_METHOD(Filled, "the file says whose it is, and is written safely") {
  REQUIRE(db.integer("PRAGMA application_id") == 0x4d726c61);
  REQUIRE(db.integer("PRAGMA user_version") == schemaVersion);
  REQUIRE(first(db, "PRAGMA journal_mode") == "delete");
  REQUIRE(first(db, "PRAGMA integrity_check") == "ok");
  REQUIRE(first(db, "PRAGMA foreign_key_check") == "(no row)");
  configure(db);
  REQUIRE(db.integer("PRAGMA synchronous") == 2);  // FULL
  REQUIRE(db.integer("PRAGMA foreign_keys") == 1);
}

TEST_CASE_METHOD(Filled, "plain SQL reads what was stored") {
  REQUIRE(first(db, "SELECT path FROM cell WHERE parent IS NULL").empty());
  REQUIRE(first(db, "SELECT group_concat(path) FROM cell WHERE parent = ''") == "A,B");
  REQUIRE(first(db, "SELECT fate || ' ' || state FROM cell WHERE path = ''") == "divided START a0");
  REQUIRE(first(db, "SELECT (ended IS NULL AND ended_step IS NULL) || '' FROM cell WHERE fate = 'alive'") == "1");
  REQUIRE(first(db, "SELECT name FROM cell WHERE path = 'A'") == "AB");
  REQUIRE(first(db, "SELECT (released IS NULL) || '' FROM connection WHERE cause = ''") == "1");
  REQUIRE(first(db, "SELECT hash FROM step_hash WHERE step = 512") == "ffffffffffffffff0000000000000000");
  REQUIRE(first(db, "SELECT typeof(content) FROM document LIMIT 1") == "blob");
  REQUIRE(first(db, "SELECT libraries FROM run").find("SQLite 3.") != std::string::npos);
  // The start was measured without a shell, so shell_fill is NULL and not 0.
  REQUIRE(first(db, "SELECT (shell_fill IS NULL AND volume > 4) || '' FROM sample WHERE time = 0") == "1");
}

TEST_CASE_METHOD(Filled, "a query keeps the values it was started with") {
  Statement s(db, "SELECT ?");
  std::string value = "long enough to live on the heap, not in the object";
  const std::string before = value;
  s.start(value);
  value.replace(0, 4, "LONG");
  REQUIRE(s.next());
  REQUIRE(s.text(0) == before);
}

TEST_CASE_METHOD(Filled, "the tables refuse what they are not made for") {
  configure(db);
  const std::string run = "'" + id + "'";
  const auto refuses = [&](const std::string& sql, const char* because) {
    INFO(sql);
    REQUIRE_THROWS_WITH(db.execute(sql), ContainsSubstring(because));
  };
  refuses("INSERT INTO time_step VALUES (" + run + ", 'soon', 0, 1)",
          "cannot store TEXT value in INTEGER column");  // STRICT
  refuses("INSERT INTO time_step VALUES (" + run + ", 9, 'half', 1)", "cannot store TEXT value in REAL column");
  refuses("INSERT INTO time_step VALUES ('nobody', 9, 0, 1)", "FOREIGN KEY");
  refuses("INSERT INTO time_step VALUES (" + run + ", 0, 0, 1)", "UNIQUE");
  refuses("INSERT INTO time_step VALUES (" + run + ", 9, NULL, 1)", "NOT NULL");  // a NaN would become NULL
  refuses("UPDATE run SET status = 'ready'", "CHECK");
  refuses("UPDATE cell SET fate = 'lost'", "CHECK");
  refuses("UPDATE check_result SET kind = 'guess'", "CHECK");
}
