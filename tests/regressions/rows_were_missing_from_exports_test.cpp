// A database with a page of another table, or with a deleted cell, was exported and shown with rows missing and exit 0.
// After check results were deleted, replay said "the same bits".
#include <filesystem>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using morula::Database;
namespace fs = std::filesystem;

namespace {

const std::string sceneInShell = R"(morula: 1
name: small
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, cell: {radius: 0.95}, contact: {}, shell: {sphere: 1}}
record: {every: 0.015625, measures: [sister_contact, energy]}
)";

struct DamagedRun {
  DamagedRun() {
    writeWhole(folder / "small.yaml", sceneInShell);
    succeeds({"run", folder / "small.yaml", "--db", whole, "--no-pictures", "--quiet", "--out", folder / "out"});
  }
  void copy() { fs::copy_file(whole, damaged, fs::copy_options::overwrite_existing); }
  void expectRefused(const std::string& because) {
    fs::remove_all(folder / "new");
    for (const Words& words : {Words{"export", damaged, "--format", "csv", "-o", folder / "new"},
                               {"export", damaged, "--format", "newick", "-o", folder / "new"},
                               {"export", damaged, "--ro-crate", folder / "new"},
                               {"lineage", damaged},
                               {"report", damaged, "-o", folder / "new.html"}}) {
      CAPTURE(words);
      refuses(words, 6, because);
      CHECK_FALSE(fs::exists(folder / "new"));
    }
  }
  TemporaryFolder folder;
  std::string whole = folder / "run.db", damaged = folder / "damaged.db";
};

}  // namespace

TEST_CASE("a file with a page of another table is not exported") {
  DamagedRun stored;
  stored.copy();
  std::uintmax_t from = 0, to = 0, size = 0;
  {
    Database db = opened(stored.damaged);
    size = static_cast<std::uintmax_t>(db.integer("PRAGMA page_size"));
    from = static_cast<std::uintmax_t>(db.integer("SELECT rootpage FROM sqlite_schema WHERE name = 'contact'"));
    to = static_cast<std::uintmax_t>(db.integer("SELECT rootpage FROM sqlite_schema WHERE name = 'measure'"));
  }
  std::string bytes = readWhole(stored.damaged);
  bytes.replace((to - 1) * size, size, bytes.substr((from - 1) * size, size));
  writeWhole(stored.damaged, bytes);
  stored.expectRefused("damaged");
}

TEST_CASE("a lineage from which a cell is gone is neither exported nor shown") {
  DamagedRun stored;
  for (const char* sql :
       {"DELETE FROM cell WHERE path = 'A'", "DELETE FROM cell WHERE path = ''", "DELETE FROM cell"}) {
    CAPTURE(sql);
    stored.copy();
    change(stored.damaged, sql);
    stored.expectRefused("was changed since it was stored");
  }
}

TEST_CASE("replay misses check results that are gone") {
  DamagedRun stored;
  CHECK(launch({"replay", stored.whole}).code == 0);
  stored.copy();
  change(stored.damaged, "DELETE FROM check_result");
  CHECK_THAT(endsWith(1, {"replay", stored.damaged}).out, ContainsSubstring("check_result") &&
                                                              ContainsSubstring("(0 are stored") &&
                                                              ContainsSubstring("NOT the same bits"));
}

TEST_CASE("replay does not write over the run that it verifies") {
  DamagedRun stored;
  const std::string before = readWhole(stored.whole);
  fs::create_symlink(stored.whole, stored.folder / "link.db");
  for (const std::string& to : {stored.whole, stored.folder / "./run.db", stored.folder / "link.db"})
    refuses({"replay", stored.whole, "--db-out", to}, 2, "holds the run that is replayed");
  CHECK((readWhole(stored.whole) == before));
}
