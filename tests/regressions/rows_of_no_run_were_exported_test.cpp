// Rows that belong to no run, as a flipped bit in a page's spare bytes makes them, were exported: each run's rows
// matched its digest. No export checked the digests of a study's own tables.
#include "catch.h"
#include "project.h"
#include "stored.h"

using namespace morula::test;

TEST_CASE("a measure's column under another name is not exported as one of another program") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(2));
  REQUIRE(project.shell("$M run scenarios/one.yaml --quiet --db run.db").code == 0);
  opened(project.folder / "run.db").execute("ALTER TABLE sample RENAME COLUMN volume TO voluMe2");
  const auto run = project.shell("$M export run.db --format csv -o tables");
  CHECK(run.code == 6);
  CHECK_THAT(run.err, ContainsSubstring(
                          "its table sample has a column 'voluMe2', which this program does not know, and no column "
                          "volume"));
}

TEST_CASE("rows of no run, and changed rows of a study's own tables, are not exported") {
  const Project project;
  project.write("scenarios/one.yaml", treeOf(2));
  project.write("scenarios/one.study.yaml",
                "morula-study: 1\nname: one\nbase: one.yaml\nvary: {cycles: {two: {}, three: {stop.cycles: "
                "3}}}\nseeds: [1]\nmeasures: [cells]\n");
  REQUIRE(
      project
          .shell(
              "$M run scenarios/one.yaml --quiet --db run.db && $M study run scenarios/one.study.yaml --out out --quiet")
          .code == 0);
  for (const std::string file : {"run.db", "out/study.db"}) {
    INFO(file);
    REQUIRE(project.shell("$M export " + file + " --format csv -o fine-" + file.substr(file.rfind('/') + 1)).code == 0);
    opened(project.folder / file)
        .execute(
            "PRAGMA foreign_keys = OFF; CREATE TEMP TABLE row AS SELECT * FROM cell LIMIT 1; UPDATE row SET run_id = 'stranger'; "
            "INSERT INTO cell SELECT * FROM row");
    const auto run = project.shell("$M export " + file + " --format csv -o tables");
    CHECK(run.code == 6);
    CHECK_THAT(run.err, ContainsSubstring("rows of the table cell have no digest"));
    CHECK_FALSE(project.has("tables"));
  }
  opened(project.folder / "out/study.db")
      .execute(
          "PRAGMA foreign_keys = OFF; DELETE FROM cell WHERE run_id = 'stranger'; UPDATE replicate SET seed = seed + 1");
  const auto study = project.shell("$M export out/study.db --format csv -o tables");
  CHECK(study.code == 6);
  CHECK_THAT(study.err, ContainsSubstring("rows of the study's table replicate were changed"));
}
