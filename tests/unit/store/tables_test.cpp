// Tables made of records' lists of fields: what SQLite has, and what is said of it.
#include <algorithm>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/run_tables.h"
#include "store/schema.h"
#include "store/store.h"
#include "temporary_folder.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

/// A file with one run in it; its id.
std::string fill(const std::filesystem::path& file) {
  Store store = Store::openForWriting(file);
  const std::string id = store.begin(exampleRecord());
  store.finish(id, exampleEnd(), exampleResults());
  return id;
}

/// "table.column TYPE", sorted.
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

TEST_CASE(".schema explains the columns") {
  const TemporaryFolder folder;
  Database db((fill(folder / "runs.db"), folder / "runs.db"), Database::Mode::existing, 1s);
  Statement s(db, "SELECT sql FROM sqlite_schema WHERE name = 'run'");
  REQUIRE(s.next());
  CHECK_THAT(s.text(0), ContainsSubstring("\"fp_environment\" TEXT NOT NULL,  -- how the processor rounds"));
  CHECK_THAT(s.text(0), ContainsSubstring("\"time\" REAL,  -- simulated [time]"));
}

TEST_CASE("a file without a measure's column is read as if it had not been measured, and gets it with the next run") {
  TemporaryFolder folder;
  const auto file = folder / "runs.db";
  const std::string id = fill(file);
  Store::openForWriting(folder / "new.db");
  {
    Database db(file, Database::Mode::existing, 1s);
    for (const char* column :
         {"sample DROP COLUMN shell_fill", "cell_sample DROP COLUMN sphericity", "bullet_sample DROP COLUMN z"})
      db.execute(std::string("ALTER TABLE ") + column);
  }
  {
    const auto samples = Store::openForReading(file).results(id).samples;
    CHECK_FALSE(samples[1].world["shell_fill"]);
    CHECK_FALSE(samples[1].cells[0]["sphericity"]);
    CHECK(samples[1].world["volume"] == exampleResults().samples[1].world["volume"]);
    CHECK(samples[1].cells[0]["neighbours"] == 1);
  }
  Store store = Store::openForWriting(file);
  store.finish(store.begin(exampleRecord()), exampleEnd(), exampleResults());
  CHECK(store.results(id).samples[1].cells[0]["sphericity"] == 1);
  CHECK(columnsIn(file) == columnsIn(folder / "new.db"));
}

TEST_CASE("a value where there must be none, and none where there must be one, are refused") {
  const TemporaryFolder folder;
  const std::string id = fill(folder / "runs.db");
  const auto refuses = [&](const char* sql, const char* because) {
    CAPTURE(sql);
    const auto file = folder / "changed.db";
    std::filesystem::copy_file(folder / "runs.db", file, std::filesystem::copy_options::overwrite_existing);
    Database(file, Database::Mode::existing, 1s).execute(sql);
    CHECK_THROWS_WITH(Store::openForReading(file).results(id), ContainsSubstring(because));
  };
  refuses("UPDATE cell SET ended = NULL WHERE path = 'B'", "ended: 'NULL'");
  refuses("UPDATE cell SET ended_step = NULL WHERE path = 'B'", "ended_step: 'NULL'");
  refuses("UPDATE division SET axis_y = 9e999", "axis_y: 'Inf' is not what Morula writes there; needs a finite number");
}
