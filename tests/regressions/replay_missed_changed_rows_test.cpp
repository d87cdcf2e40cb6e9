// replay compared only hashes and said "the same bits" of a database with doubled samples or deleted cells. Now it
// compares every stored value with the repeated run's, and reports table, row, column and both values of the first
// difference, and the number of rows that differ.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string recordedScene = R"(morula: 1
name: small
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, cell: {radius: 0.95}, contact: {}, shell: {sphere: 1}}
connections: {make: at-division}
record: {every: 0.5, measures: [sister_contact]}
check: {end-roundness: 0.1}
)";

struct Change {
  const char *table, *sql, *said;
};

}  // namespace

TEST_CASE("replay: a changed, lost or added row of any table is found and named") {
  const TemporaryFolder folder;
  writeWhole(folder / "small.yaml", recordedScene);
  const std::string whole = folder / "run.db", changed = folder / "changed.db";
  succeeds({"run", folder / "small.yaml", "--db", whole, "--no-pictures", "--out", folder / "out"});
  CHECK_THAT(succeeds({"replay", whole}).out, ContainsSubstring("tables          all 15 the same"));

  const Change changes[] = {
      {"sample", "UPDATE sample SET volume = volume * 2", "of 4 rows differ\n    first time 0: volume: stored "},
      {"cell", "DELETE FROM cell", "(0 are stored, 3 recomputed)"},
      {"cell", "DELETE FROM cell WHERE path = 'B'", "first path B: stored: no such row; recomputed: a row"},
      {"cell", "UPDATE cell SET state = 'a9' WHERE path = 'A'", "first path A: state: stored 'a9', recomputed '"},
      {"cell", "UPDATE cell SET name = 'ABp' WHERE path = 'A'", "name: stored 'ABp', recomputed nothing"},
      {"cell_sample", "UPDATE cell_sample SET x = x + 1e-15 WHERE time = 1.5 AND path = 'A'",
       "1 of 6 rows differ\n    first time 1.5, path A: x: stored "},
      {"cell_sample", "UPDATE cell_sample SET pressure = NULL WHERE time = 0", "pressure: stored nothing, recomputed "},
      {"contact", "DELETE FROM contact", "are stored"},
      {"measure", "UPDATE measure SET value = 0.5 WHERE time = 1", "name sister_contact"},
      {"time_step", "UPDATE time_step SET time_step = 0.5 WHERE step = 0", "step 0: time_step: stored 0.5"},
      {"step_hash", "UPDATE step_hash SET lineage = state WHERE step = 64", "first step 64: lineage: stored '"},
      {"cell_hash", "DELETE FROM cell_hash WHERE step = 64", "no such row; recomputed: a row"},
      {"check_result", "UPDATE check_result SET actual = '2' WHERE \"check\" = 'shell'", "actual: stored '2'"},
      {"division", "UPDATE division SET share = 0.25", "share: stored 0.25, recomputed "},
      {"run", "UPDATE run SET cells = 7", "cells: stored 7, recomputed 2"},
  };
  for (const Change& c : changes) {
    CAPTURE(c.sql);
    std::filesystem::copy_file(whole, changed, std::filesystem::copy_options::overwrite_existing);
    change(changed, c.sql);
    CHECK_THAT(endsWith(1, {"replay", changed}).out, ContainsSubstring(std::string("\n  ") + c.table + ' ') &&
                                                         ContainsSubstring(c.said) &&
                                                         ContainsSubstring("NOT the same bits"));
  }
  const Json json = jsonOf({"replay", changed}, 1);
  CHECK(json["same_bits"] == false);
  for (const auto& table : json["tables"])
    if (table["table"] == "run") CHECK(table["first"]["column"] == "cells");
}
