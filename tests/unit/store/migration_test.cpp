// Files of earlier versions are brought up to date, and keep what they hold.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "catch.h"
#include "database/schema.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/store.h"
#include "temporary_folder.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

void makeVersion1(const std::filesystem::path& file) {
  std::ifstream sql(MORULA_SOURCE_DIR "/tests/unit/store/version1.sql");
  Database(file, Database::Mode::create, 1s).execute({std::istreambuf_iterator<char>(sql), {}});
}

/// Tables and columns, in the order of the file.
std::vector<std::string> columnsOf(const std::filesystem::path& file) {
  Database db(file, Database::Mode::existing, 1s);
  Statement s(
      db,
      "SELECT m.name || '.' || c.name || ' ' || c.type || ' ' || c.\"notnull\" || ' ' || c.pk "
      "FROM sqlite_schema m, pragma_table_info(m.name) c WHERE m.type = 'table' ORDER BY m.name, c.cid");
  std::vector<std::string> columns;
  while (s.next()) columns.push_back(s.text(0));
  return columns;
}

}  // namespace

TEST_CASE("a file of the first version is brought up to date by the first run into it, and loses nothing") {
  TemporaryFolder folder;
  const auto file = folder / "old.db";
  makeVersion1(file);
  CHECK_THROWS_WITH(Store::openForReading(file), ContainsSubstring("older Morula (database version 1)"));

  std::string id;
  {
    Store store = Store::openForWriting(file);
    const StoredRun old = store.find("0123456789abcdef");
    CHECK(old.status == RunStatus::done);
    CHECK(old.stateHash == "000102030405060708090a0b0c0d0e0f");
    CHECK(old.record.binaryHash == "unknown");
    CHECK(old.record.machine.fpEnvironment == "unknown");
    CHECK(old.record.machine.features == "unknown");
    CHECK(store.results(old.id).lineage.size() == 3);
    CHECK(store.results(old.id).chain.empty());  // of another make then
    CHECK(store.documents(old.id)[0].content == "morula: 1\n");
    id = store.begin(exampleRecord());
    store.finish(id, exampleEnd(), exampleResults());
  }
  Store store = Store::openForReading(file);
  CHECK(store.runs().size() == 2);
  CHECK(store.find(id).record.binaryHash == exampleRecord().binaryHash);
}

TEST_CASE("a file that was brought up to date has the tables of a new one") {
  TemporaryFolder folder;
  makeVersion1(folder / "old.db");
  Store::openForWriting(folder / "old.db");
  Store::openForWriting(folder / "new.db");
  CHECK(columnsOf(folder / "old.db") == columnsOf(folder / "new.db"));
  Database db(folder / "old.db", Database::Mode::existing, 1s);
  CHECK(db.integer("PRAGMA user_version") == schemaVersion());
  Statement check(db, "PRAGMA integrity_check");
  REQUIRE(check.next());
  CHECK(check.text(0) == "ok");
}

TEST_CASE(
    "a file without a measure's column is read as if it had not been measured, and gets it with the next "
    "run") {
  TemporaryFolder folder;
  const auto file = folder / "runs.db";
  std::string id;
  {
    Store store = Store::openForWriting(file);
    id = store.begin(exampleRecord());
    store.finish(id, exampleEnd(), exampleResults());
  }
  Store::openForWriting(folder / "new.db");
  {
    Database db(file, Database::Mode::existing, 1s);
    for (const char* column : {"sample DROP COLUMN shell_fill", "cell_sample DROP COLUMN sphericity",
                               "bullet_sample DROP COLUMN z"})
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
  auto now = columnsOf(file), fresh = columnsOf(folder / "new.db");
  std::ranges::sort(now), std::ranges::sort(fresh);
  CHECK(now == fresh);
}
