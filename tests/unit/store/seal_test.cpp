// requireSealed detects a change after storing in any column of any table.
#include "store/seal.h"

#include <set>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"
#include "store/run_tables.h"

using namespace morula;

namespace {

struct SealedRun {
  SealedRun() {
    Store store = Store::openForWriting(file);
    id = store.begin(exampleRecord());
    store.keepCheckpoint(id, {512, {}, 512, "state"}, {}, {1, [](std::size_t) { return std::string("frame"); }});
    store.finish(id, exampleEnd(), exampleResults());
    store.putBulletSamples(id, "b1", exampleResults().samples);
  }
  TemporaryFolder folder;
  std::string file = folder / "runs.db", id;
};

bool isSealed(Database& db, const std::string& id) {
  try {
    requireSealed(db, id);
    requireAllSealed(db, [](TablePart) { return true; });
    return true;
  } catch (const StoreError&) { return false; }
}

}  // namespace

TEST_CASE("A changed value in any column of any table of a run is detected, and so is a missing row") {
  const SealedRun stored;
  Database db(stored.file, Database::Mode::existing, std::chrono::seconds(1));
  REQUIRE(isSealed(db, stored.id));
  db.execute("PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON");
  std::set<std::string> tried;
  for (const SqlTable* table : runTables()) {
    const std::string name = table->info.name;
    if (table == &sqlTable<StoredText>() || table->info.part == TablePart::seal) continue;
    if (db.integer("SELECT count(*) FROM " + name) == 0) continue;
    tried.insert(name);
    for (const auto* columns : {&table->context, &table->own})
      for (const SqlColumn& c : *columns) {
        CAPTURE(name, c.name);
        Transaction transaction(db);  // rolled back at the end of the scope
        const std::string other = c.type.starts_with("INTEGER") ? "ifnull(" + sqlName(c.name) + " + 1000000, 1)"
                                  : c.type.starts_with("REAL")  ? "ifnull(" + sqlName(c.name) + " * 0.5 + 1, 1.0)"
                                  : c.type.starts_with("BLOB")  ? "CAST('x' AS BLOB)"
                                                                : "ifnull(" + sqlName(c.name) + ", '') || 'x'";
        db.execute("UPDATE " + name + " SET " + sqlName(c.name) + " = " + other);
        CHECK_FALSE(isSealed(db, stored.id));
      }
    CAPTURE(name);
    {
      Transaction transaction(db);
      db.execute("DELETE FROM " + name);
      CHECK_FALSE(isSealed(db, stored.id));
    }
    if (table->own.back().type.find("NOT NULL") == std::string::npos) {
      Transaction transaction(db);
      db.execute("ALTER TABLE " + name + " RENAME COLUMN " + sqlName(table->own.front().name) + " TO other");
      CHECK_FALSE(isSealed(db, stored.id));
    }
  }
  CHECK(tried.size() >= 13);
  CHECK(isSealed(db, stored.id));
}

TEST_CASE("Digests do not depend on the order of rows, and the digests of parts add up to that of the whole") {
  const TemporaryFolder folder;
  Database db(folder / "t.db", Database::Mode::create, std::chrono::seconds(1));
  db.execute("CREATE TABLE a (n INTEGER, x REAL, t TEXT); CREATE TABLE b (t TEXT, x REAL, n INTEGER, later REAL)");
  db.execute("INSERT INTO a VALUES (1, 0.5, 'x'), (2, -0.0, NULL), (2, 0.0, ''), (NULL, 1e300, 'y')");
  db.execute("INSERT INTO b SELECT t, x, n, NULL FROM a ORDER BY n DESC");
  const RowDigest all = digestRows(db, "a", "");
  CHECK(all.rows == 4);
  CHECK(digestRows(db, "b", "") == all);
  RowDigest parts = digestRows(db, "a", "n = ?", 2);
  CHECK(parts.rows == 2);
  parts += digestRows(db, "a", "n IS NOT 2");
  CHECK(parts == all);
  db.execute("UPDATE a SET n = x, x = n WHERE n = 1");
  CHECK(digestRows(db, "a", "") != all);
}
