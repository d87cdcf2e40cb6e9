// Tables made from records' lists of fields: SQLite's columns, and their descriptions.
#include <algorithm>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/run_tables.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

/// Returns "table.column TYPE" of each column, sorted.
std::vector<std::string> columnsIn(const std::filesystem::path& file) {
  Database db(file, Database::Mode::existing, 1s);
  std::vector<std::string> columns;
  Statement s(db,
              "SELECT m.name || '.' || c.name || ' ' || c.type FROM sqlite_schema m, "
              "pragma_table_info(m.name) c WHERE m.type = 'table'");
  while (s.next()) columns.push_back(s.text(0));
  std::ranges::sort(columns);
  return columns;
}

}  // namespace

TEST_CASE("each table says why it is there, and each column of it is told once") {
  for (const SqlTable* t : runTables()) {
    CAPTURE(t->info.name);
    CHECK(std::string(t->info.why).size() > 10);
    std::vector<std::string> names;
    for (const auto* columns : {&t->context, &t->own})
      for (const SqlColumn& c : *columns) names.push_back(c.name);
    std::ranges::sort(names);
    CHECK(std::ranges::adjacent_find(names) == names.end());
  }
}

TEST_CASE_METHOD(ResultsFile, ".schema explains the columns") {
  Database db = database();
  Statement s(db, "SELECT sql FROM sqlite_schema WHERE name = 'run'");
  REQUIRE(s.next());
  CHECK_THAT(s.text(0), ContainsSubstring("\"fp_environment\" TEXT NOT NULL,  -- how the processor rounds"));
  CHECK_THAT(s.text(0), ContainsSubstring("\"time\" REAL,  -- simulated [time]"));
}

TEST_CASE_METHOD(
    FinishedRun,
    "a file without a measure's column is read as if it had not been measured, and gets it with the next run") {
  Store::openForWriting(folder / "new.db");
  for (const char* column :
       {"sample DROP COLUMN shell_fill", "cell_sample DROP COLUMN sphericity", "bullet_sample DROP COLUMN z"})
    database().execute(std::string("ALTER TABLE ") + column);
  {
    const auto samples = Store::openForReading(file).results(id).samples;
    CHECK_FALSE(samples[1].world["shell_fill"]);
    CHECK_FALSE(samples[1].cells[0]["sphericity"]);
    CHECK(samples[1].world["volume"] == exampleResults().samples[1].world["volume"]);
    CHECK(samples[1].cells[0]["neighbours"] == 1);
  }
  store = Store::openForWriting(file);
  store.begin(exampleRecord());
  finish();
  CHECK(store.results(id).samples[1].cells[0]["sphericity"] == 1);
  CHECK(columnsIn(file) == columnsIn(folder / "new.db"));
}

TEST_CASE_METHOD(FinishedRun, "a file without a column that is no measure is of another version, and is not read") {
  database().execute("ALTER TABLE run DROP COLUMN mother_run_id");
  CHECK_THROWS_WITH(Store::openForReading(file), ContainsSubstring("its table run has no column mother_run_id"));
}

TEST_CASE_METHOD(FinishedRun, "a value where there must be none, and none where there must be one, are refused") {
  const auto refuses = [&](const char* sql, const char* because) {
    CAPTURE(sql);
    const auto changed = folder / "changed.db";
    std::filesystem::copy_file(file, changed, std::filesystem::copy_options::overwrite_existing);
    Database(changed, Database::Mode::existing, 1s).execute(sql);
    CHECK_THROWS_WITH(Store::openForReading(changed).results(id), ContainsSubstring(because));
  };
  refuses("UPDATE cell SET ended = NULL WHERE path = 'B'", "ended: 'NULL'");
  refuses("UPDATE cell SET ended_step = NULL WHERE path = 'B'", "ended_step: 'NULL'");
  refuses("UPDATE division SET axis_y = 9e999",
          "axis_y: 'Inf' is not a value that Morula writes; needs a finite "
          "number");
}
