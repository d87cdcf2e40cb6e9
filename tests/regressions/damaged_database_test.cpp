// A database with user_version -1 ended `run --db` by SIGSEGV; an unknown status or a hash with other digits ended
// readers with exit 70, as bugs. Now every verb ends with an answer or with a sentence, whatever a column holds.
#include <filesystem>

#include "catch.h"
#include "hostile.h"
#include "store/store.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;
namespace fs = std::filesystem;

namespace {

/// A database of one run with all tables filled, and without constraints on their values.
struct Loose {
  Loose() {
    writeWhole(folder / "small.yaml", smallScene);
    writeWhole(folder / "body.yaml", smallBody);
    for (const char* scene : {"small.yaml", "body.yaml"})
      succeeds(
          {"run", "--quiet", "--no-pictures", "--set", "record.every=0.0078125", "--db", original, folder / scene});
    auto db = opened(original);
    db.execute("PRAGMA writable_schema = ON");
    for (const char* promise : {"' STRICT, ', ' '", "' STRICT', ''", "'NOT NULL', ''"})
      db.execute(std::string("UPDATE sqlite_schema SET sql = replace(sql, ") + promise + ")");
    db.execute("PRAGMA writable_schema = RESET");
  }
  /// Changes a copy of the database. Returns false if SQLite itself refuses the change.
  bool damage(const std::string& sql) {
    fs::copy_file(original, damaged, fs::copy_options::overwrite_existing);
    try {
      change(damaged,
             "PRAGMA ignore_check_constraints = ON; PRAGMA foreign_keys = OFF; PRAGMA synchronous = OFF; " + sql);
    } catch (const FileError&) { return false; }
    return true;
  }
  TemporaryFolder folder;
  std::string original = folder / "original.db", damaged = folder / "damaged.db";
};

const char* const values[] = {"NULL",  "''",    "'odd'", "x'00ff1b'", "-1", "0", "9223372036854775807",
                              "1e308", "9e999", "0.5"};

void checkEnds(const std::vector<std::string>& words) {
  const auto run = launch(words);
  CAPTURE(words[0], run.code, run.err);
  CHECK(run.code != 70);
  CHECK(run.code < 128);
  CHECK((run.code == 0 || run.code == 1 || !run.err.empty()));
}

}  // namespace

TEST_CASE("a database version that is none is told") {
  Loose loose;
  for (const char* version : {"-1", "-2147483648", "2147483647", "1", "0"}) {
    CAPTURE(version);
    REQUIRE(loose.damage(std::string("PRAGMA user_version = ") + version));
    const auto run =
        launch({"run", "--quiet", "--no-check", "--no-pictures", "--db", loose.damaged, loose.folder / "small.yaml"});
    CAPTURE(run.err);
    CHECK(run.code == 6);
    CHECK(launch({"export", loose.damaged}).code == 6);
  }
}

TEST_CASE("whatever a column holds, reading ends with a FileError or an answer") {
  Loose loose;
  std::vector<std::pair<std::string, std::string>> columns;
  {
    auto db = opened(loose.original);
    Statement s(db,
                "SELECT t.name, c.name FROM sqlite_schema AS t, pragma_table_info(t.name) AS c WHERE t.type = 'table'");
    for (s.start(); s.next();) columns.emplace_back(s.text(0), s.text(1));
  }
  REQUIRE(columns.size() > 90);
  int tried = 0, refused = 0;
  for (const auto& [table, column] : columns)
    for (const char* value : values) {
      if (!loose.damage("UPDATE " + table + " SET \"" + column + "\" = " + value)) continue;
      CAPTURE(table, column, value);
      ++tried;
      const auto read = [&](auto&& what) {
        try {
          what();
        } catch (const FileError&) { ++refused; } catch (const std::exception& other) {
          FAIL_CHECK(other.what());
        }
      };
      read([&] {
        auto store = Store::openForReading(loose.damaged);
        for (const auto& run : store.runs()) {
          read([&] { store.results(run.id); });
          read([&] { store.documents(run.id); });
          read([&] { store.resume(run.record); });
        }
      });
    }
  CHECK(tried > 500);
  CHECK(refused > 200);
}

TEST_CASE("every verb that reads a damaged database ends with a code of its own") {
  Loose loose;
  const auto small = loose.folder / "small.yaml";
  for (const std::string damage :
       {"UPDATE run SET status = 'odd'", "UPDATE run SET state_hash = 'xyz'",
        "UPDATE run SET threads = 9223372036854775807", "UPDATE run SET steps = -1",
        "UPDATE run SET run_id = '../../x' WHERE scenario = 'small'",
        "UPDATE step_hash SET hash = 'g' || substr(hash, 2)", "UPDATE step_hash SET step = 9223372036854775807 - step",
        "UPDATE cell SET path = 'AXB' WHERE path = 'AB'", "UPDATE cell SET fate = 'odd'",
        "UPDATE cell SET born = 9e999, ended = NULL", "UPDATE document SET content = x'ff00'",
        "UPDATE run_document SET role = NULL", "DELETE FROM document", "DELETE FROM cell", "DELETE FROM run",
        "DROP TABLE cell", "ALTER TABLE run RENAME TO r; CREATE VIEW run AS SELECT * FROM r",
        "CREATE TRIGGER t AFTER INSERT ON run BEGIN DELETE FROM cell; END"}) {
    CAPTURE(damage);
    const bool done = loose.damage(damage);
    CHECK(done);
    checkEnds({"export", loose.damaged});
    checkEnds({"export", loose.damaged, "--ro-crate", loose.folder / "crate"});
    fs::remove_all(loose.folder / "crate");
    checkEnds({"lineage", loose.damaged});
    checkEnds({"replay", loose.damaged});
    checkEnds({"explain", "--db", loose.damaged, small});
    checkEnds({"run", "--no-pictures", "--resume", "--db", loose.damaged, small});
  }
}
