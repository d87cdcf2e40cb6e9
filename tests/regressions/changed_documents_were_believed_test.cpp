// An edited stored scenario was believed: replay ran it and said "the same bits", and export packed it. Now every
// reader checks a run's documents against their hashes, and the run's id against its origin.
#include <filesystem>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
namespace fs = std::filesystem;

TEST_CASE("a stored run whose record was changed is neither replayed, drawn, explained nor exported") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "small.yaml", whole = folder / "run.db", db = folder / "changed.db";
  writeWhole(scenario, "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 3}\ncheck: {}\n");
  succeeds({"run", scenario, "--db", whole, "--no-pictures", "--out", folder / "out"});

  const std::string ofRole = " WHERE hash = (SELECT hash FROM run_document WHERE role = '";
  const std::string edit = "UPDATE document SET content = CAST(replace(CAST(content AS TEXT), '3', '2') AS BLOB)";
  for (const std::string& sql :
       {edit + ofRole + "resolved')", edit + ofRole + "scenario')",
        std::string("UPDATE run_document SET hash = (SELECT max(hash) FROM document WHERE hash <> run_document.hash) "
                    "WHERE role = 'resolved'; DELETE FROM document WHERE hash = (SELECT hash FROM run_document WHERE "
                    "role = 'scenario')"),
        std::string("UPDATE run SET seed = 7"), std::string("UPDATE run SET sources = 'other'"),
        std::string("UPDATE run SET build_id = 'other'"), std::string("UPDATE run SET scenario_hash = 'other'")}) {
    CAPTURE(sql);
    fs::copy_file(whole, db, fs::copy_options::overwrite_existing);
    change(db, sql);
    CHECK_THAT(endsWith(1, {"replay", db}).out,
               ContainsSubstring("its record was changed") && ContainsSubstring("recomputed"));
    const std::string crate = folder / "crate";
    for (const Words& verb : {Words{"export", db, "--ro-crate", crate},
                              {"render", db, "-o", folder / "x.png"},
                              {"explain", scenario, "--db", db}})
      refuses(verb, 6, "was changed since it was stored");
    CHECK_FALSE(fs::exists(crate));
  }
  CHECK(launch({"replay", whole}).code == 0);
  CHECK(launch({"export", whole, "--ro-crate", folder / "crate"}).code == 0);
}
