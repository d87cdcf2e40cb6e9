// Merging: in any order, from anywhere, and without invalid files.
#include <algorithm>

#include "catch.h"
#include "small_study.h"
#include "study_store/merged_study.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

std::string plain(const std::filesystem::path& database) {
  const TemporaryFolder folder;
  std::filesystem::copy(database, folder / "copy.db");
  Database db(folder / "copy.db", Database::Mode::existing, 1s);
  db.execute("DELETE FROM timing");
  db.execute("VACUUM INTO '" + (folder / "plain.db").string() + "'");
  return readText(folder / "plain.db");
}

struct Computed : SmallStudy {
  PlannedStudy study = open();
  Computed() { run(study); }
  MergeReport merge(const std::vector<std::string>& shards = {}, const std::string& to = "study.db") const {
    return mergeStudy(study, {shards, folder / to});
  }
  std::filesystem::path file(std::size_t task) const { return fileOf(study, task); }
};

}  // namespace

TEST_CASE("shards in any order, some of them twice, make the same bytes") {
  const Computed c;
  CHECK(c.merge().done == 8);
  const std::string whole = plain(c.folder / "study.db");
  std::filesystem::create_directories(c.folder / "one");
  std::filesystem::create_directories(c.folder / "two/tasks");
  for (std::size_t t = 0; t < 8; ++t) {
    std::filesystem::copy(c.file(t), c.folder / (t % 2 ? "one" : "two/tasks") / c.file(t).filename());
    if (t < 3)
      std::filesystem::copy(c.file(t), c.folder / "one" / c.file(t).filename(),
                            std::filesystem::copy_options::overwrite_existing);
    std::filesystem::remove(c.file(t));
  }
  const MergeReport none = c.merge({}, "none.db");
  CHECK((none.done == 0 && none.missing.size() == 8));
  std::vector<std::string> shards{(c.folder / "one").string(), (c.folder / "two").string()};
  c.merge(shards, "a.db");
  CHECK(plain(c.folder / "a.db") == whole);
  std::ranges::reverse(shards);
  c.merge(shards, "a.db");  // merges again into the existing file
  CHECK(plain(c.folder / "a.db") == whole);
}

TEST_CASE("what is damaged or of another study is left out and told") {
  const Computed c;
  Database(c.file(2), Database::Mode::existing, 1s).execute("UPDATE result SET value = value + 1");
  std::filesystem::resize_file(c.file(3), 1000);
  std::filesystem::copy(c.file(4), c.folder / "renamed.db");
  std::filesystem::rename(c.file(4), c.file(5));  // a task's file in another task's place
  writeText(c.folder / "out/tasks/0123456789abcdef.db", "");
  const MergeReport report = c.merge();
  CHECK(report.damaged.size() == 3);
  CHECK(report.missing == std::vector<std::size_t>{2, 3, 4, 5});
  CHECK(report.foreign.size() == 1);
  CHECK(report.done == 4);
  CHECK(c.merge({(c.folder / "renamed.db").string()}).missing == std::vector<std::size_t>{2, 3, 5});
}

TEST_CASE("one task with two results is nondeterminism, and nothing is written") {
  const Computed c;
  const SmallStudy other;
  const PlannedStudy again = other.open();
  other.run(again, {3});
  TaskFile there(fileOf(again, 3));
  CHECK(c.merge({again.folder.path().string()}).differing.empty());
  const std::string before = readText(c.folder / "study.db");
  {
    // A careful change: the file's own hash follows its content.
    Database db(fileOf(again, 3), Database::Mode::existing, 1s);
    db.execute("UPDATE result SET value = value + 1 WHERE measure = 'generation'");
    Statement(db, "UPDATE task SET result_hash = ?").run(resultHash(db, there.run().id).text());
  }
  const MergeReport report = c.merge({again.folder.path().string()});
  REQUIRE(report.differing.size() == 1);
  CHECK(report.differing[0].task == 3);
  CHECK(report.differing[0].hashA != report.differing[0].hashB);
  const std::string text = describe(report, c.study);
  CHECK_THAT(text, ContainsSubstring("NONDETERMINISM") && ContainsSubstring(report.differing[0].a.string()) &&
                       ContainsSubstring(report.differing[0].b.string()));
  CHECK(readText(c.folder / "study.db") == before);
}

TEST_CASE("the merged database holds the design") {
  const Computed c;
  c.merge();
  Database db(c.folder / "study.db", Database::Mode::existing, 1s);
  CHECK(db.integer("SELECT count(*) FROM replicate") == 12);
  CHECK(db.integer("SELECT count(*) FROM axis") == 2);
  CHECK(db.integer("SELECT count(*) FROM level") == 4);
  CHECK(db.integer("SELECT sum(distinct_runs) FROM condition WHERE uses_seed") == 6);
  CHECK(db.integer("SELECT sum(distinct_runs) FROM condition WHERE NOT uses_seed") == 2);
  CHECK(db.integer("SELECT count(*) FROM condition_key WHERE \"cycle.length\" = '2' OR \"cycle.length\" = '2.0'") == 2);
  CHECK(db.integer("SELECT count(DISTINCT run_id) FROM result") == 8);
  // Every replicate has its values, through the run that it shares.
  CHECK(db.integer("SELECT count(*) FROM replicate JOIN task USING (task_id) JOIN result USING (run_id) WHERE measure "
                   "= 'cells'") == 12);
}
