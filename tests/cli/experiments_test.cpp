// Experiments, start cells from a table, and conditions that end a run, as users meet them.
#include <filesystem>

#include "launch.h"
// Included last, because of CHECK:
#include "catch.h"

using namespace morula::test;
using Catch::Matchers::Contains;

namespace {

const std::string head =
    "morula: 1\nname: four\ndna: |\n  START: a0\n  g1(a1|a0)\n  g2(divide|a0)\n  g3(a2|a1, A)\n  g4(a3|a1, B)\n"
    "  g5(divide|a1)\n  g6(a2|a2)\n  g7(a3|a3)\nnames: {egg: P0, daughters: [a, p]}\n";

}  // namespace

TEST_CASE("lineage tells what was done to which cell, and marks it in the tree") {
  const TemporaryFolder folder;
  const std::string with = folder / "with.yaml", without = folder / "without.yaml", db = folder / "with.db";
  const std::string scene = head + "stop: {time: 4}\nphysics: {mesh: {icosphere: 1}, contact: {}}\n";
  writeWhole(without, scene);
  writeWhole(with, scene + "experiments: [{kill: cell P0aa, at: 2.5}, {set: physics.drag, to: 3, at: 1.5}]\n");
  succeeds({"run", with, "--db", db, "--no-pictures", "--no-check", "--out", folder / "out"});
  for (const std::string& file : {with, db}) {
    const std::string told = succeeds({"lineage", file}).out;
    CHECK_THAT(told, Contains("experiment: kill at time 2.5") && Contains("P0aa"));
    CHECK_THAT(told, Contains("experiment: set physics.drag to 3 at time 1.5"));
    CHECK(jsonOf({"lineage", file, "--json"}).at("experiments").size() == 2);
    succeeds({"lineage", file, "-o", folder / "tree.svg", "--quiet"});
    CHECK_THAT(readWhole(folder / "tree.svg"), Contains("stroke-dasharray"));
  }
  CHECK_THAT(succeeds({"lineage", without}).out, !Contains("experiment"));
  succeeds({"parts", with});  // predicts by genes alone, which have no drag to set
  succeeds({"lineage", without, "-o", folder / "plain.svg", "--quiet"});
  CHECK_THAT(readWhole(folder / "plain.svg"), !Contains("stroke-dasharray"));
}

TEST_CASE("A run that a condition ends says which") {
  const TemporaryFolder folder;
  writeWhole(folder / "four.yaml", head + "stop: {time: 9, when: [{born: cell P0pa}]}\n");
  const auto run = succeeds({"run", folder / "four.yaml", "--db", folder / "four.db", "--out", folder / "out"});
  CHECK_THAT(run.out, Contains("at time 2") && Contains("stopped  stop.when: {born: cell P0pa} holds"));
  CHECK(jsonOf({"run", folder / "four.yaml", "--db", folder / "four.db", "--out", folder / "out", "--json"})
            .at("stopped") == "{born: cell P0pa}");
}

TEST_CASE("A scenario begins with the cells of a table, and its database runs again without the table") {
  const TemporaryFolder folder;
  writeWhole(folder / "cells.csv", "name,x,y,z,radius\nleft,-2,0,0,1\nright,2,0,0,0.8\n");
  writeWhole(folder / "two.yaml",
             "morula: 1\nname: two\ndna: 'START: a0'\nstop: {time: 0.5}\nphysics: {mesh: {icosphere: 1}}\n"
             "cells: {file: cells.csv}\n");
  succeeds({"run", folder / "two.yaml", "--db", folder / "two.db", "--no-pictures", "--out", folder / "out"});
  std::filesystem::remove(folder / "cells.csv");
  CHECK_THAT(succeeds({"replay", folder / "two.db"}).out, Contains("the same bits"));
  CHECK_THAT(succeeds({"lineage", folder / "two.db"}).out, Contains("right"));
}
