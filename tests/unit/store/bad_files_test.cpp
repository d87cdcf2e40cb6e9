// Unusable files: each is refused with its reason, and left as it was.
#include <sys/stat.h>
#include <unistd.h>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/result_file.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

void refuses(const std::filesystem::path& file, const std::string& because) {
  const std::string before = readText(file);
  for (const auto open : {Store::openForWriting, Store::openForReading}) {
    try {
      open(file, {.patience = 10ms});
      FAIL("opened");
    } catch (const StoreError& e) {
      REQUIRE_THAT(e.what(), Catch::Matchers::StartsWith(file.string()) && ContainsSubstring(because));
    }
  }
  REQUIRE(readText(file) == before);
}

Database emptyDatabase(const std::filesystem::path& file) { return Database(file, Database::Mode::create, 1s); }

}  // namespace

TEST_CASE("a file that is no database") {
  TemporaryFolder folder;
  const auto file = folder / "notes.txt";
  writeText(file, std::string(2000, 'x'));
  refuses(file, "the file is not an SQLite database");
}

TEST_CASE("a database of another program") {
  TemporaryFolder folder;
  const auto file = folder / "theirs.db";
  SECTION("with tables and no application id") { emptyDatabase(file).execute("CREATE TABLE theirs (x)"); }
  SECTION("with an application id") { emptyDatabase(file).execute("PRAGMA application_id = 7"); }
  refuses(file, "not one of Morula's");
}

TEST_CASE("a file of another version") {
  TemporaryFolder folder;
  for (const int version : {-1, 0, 1, schemaVersion - 1, schemaVersion + 1}) {
    const auto file = folder / (std::to_string(version) + ".db");
    Store::openForWriting(file);
    emptyDatabase(file).execute("PRAGMA user_version = " + std::to_string(version));
    refuses(file, "another version of Morula (database version " + std::to_string(version));
  }
}

TEST_CASE_METHOD(FinishedRun, "a damaged file") {
  std::string bytes = readText(file);
  for (std::size_t i = 4096; i < bytes.size(); ++i) bytes[i] = '\x5a';  // all but the first page
  writeText(file, bytes);
  REQUIRE_THROWS_WITH(Store::openForReading(file).runs(), ContainsSubstring("the file is damaged"));
}

TEST_CASE("no file, no directory, a directory") {
  TemporaryFolder folder;
  REQUIRE_THROWS_WITH(Store::openForReading(folder / "none.db"), ContainsSubstring("no such file"));
  REQUIRE_FALSE(std::filesystem::exists(folder / "none.db"));
  REQUIRE_THROWS_WITH(Store::openForWriting(folder / "none/none.db"),
                      ContainsSubstring("none does not exist; make it"));
  REQUIRE_THROWS_WITH(Store::openForWriting(folder.path()), ContainsSubstring("the path is a directory; give a file"));
}

TEST_CASE("an empty file is a new database, but nothing to read from") {
  TemporaryFolder folder;
  const auto file = folder / "empty.db";
  writeText(file, "");
  REQUIRE_THROWS_WITH(Store::openForReading(file), ContainsSubstring("the file is empty"));
  Store::openForWriting(file);
  REQUIRE(Store::openForReading(file).runs().empty());
  REQUIRE_THROWS_WITH(Store::openForReading(file).find(""), ContainsSubstring("no runs"));
}

TEST_CASE("a directory that cannot be written to") {
  TemporaryFolder folder;
  // /proc refuses everybody; permissions do not stop the administrator.
  std::filesystem::path file = "/proc/morula.db";
  if (geteuid() != 0) {
    std::filesystem::create_directory(folder / "closed");
    chmod((folder / "closed").c_str(), 0555);
    file = folder / "closed/runs.db";
  }
  REQUIRE_THROWS_WITH(Store::openForWriting(file),
                      ContainsSubstring("cannot be made in") && ContainsSubstring("writable"));
}

TEST_CASE_METHOD(FinishedRun, "a file that cannot be written to can be read") {
  if (geteuid() == 0) return;  // the administrator may write everywhere
  chmod(file.c_str(), 0444);
  REQUIRE(Store::openForReading(file).runs().size() == 1);
  REQUIRE_THROWS_WITH(Store::openForWriting(file), ContainsSubstring("not writable"));
}

TEST_CASE("a file that another process is writing to") {
  TemporaryFolder folder;
  const auto file = folder / "runs.db";
  Store store = Store::openForWriting(file, {.patience = 20ms});
  Database other(file, Database::Mode::existing, 20ms);
  {
    Transaction transaction(other);
    REQUIRE_THROWS_WITH(store.begin(exampleRecord()), ContainsSubstring("another process holds the file"));
  }
  REQUIRE(store.runs().empty());
  store.begin(exampleRecord());  // works once the other process has finished
  REQUIRE(store.runs().size() == 1);
}

TEST_CASE("a database in write-ahead mode is switched back") {
  TemporaryFolder folder;
  const auto file = folder / "runs.db";
  Store::openForWriting(file);
  emptyDatabase(file).execute("PRAGMA journal_mode = WAL");
  Store::openForWriting(file);
  Database db = emptyDatabase(file);
  Statement mode(db, "PRAGMA journal_mode");
  REQUIRE(mode.next());
  REQUIRE(mode.text(0) == "delete");
}
