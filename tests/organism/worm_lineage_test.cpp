// The worm's lineage [Sulston, Schierenberg, White & Thomson 1983]: counts of the literature, both encodings of the
// lineage, and a table of it cell for cell if there is one.
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "catch.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

using namespace morula;

namespace {

struct Run {
  Scenario scenario;
  World world;
  explicit Run(const std::string& name)
      : scenario(loadScenario(MORULA_SOURCE_DIR "/scenarios/worm/" + name + ".yaml")),
        world(makeWorld(scenario.scene)) {
    while (!finished(world)) step(world);
  }
};

struct Leaves {
  int all = 0, dead = 0;
  friend bool operator==(const Leaves&, const Leaves&) = default;
};

/// Counts the leaves whose paths begin with `founder`.
Leaves leavesOf(const Lineage& lineage, const std::string& founder) {
  Leaves leaves;
  for (const LineageEntry& cell : lineage.entries) {
    const std::string path = cell.path.isEgg() ? "" : cell.path.text();
    if (cell.fate == Fate::divided || !path.starts_with(founder)) continue;
    ++leaves.all;
    leaves.dead += cell.fate == Fate::died;
  }
  return leaves;
}

/// Reads the table. Columns: cell, parent, direction, end, tissue, division time.
std::map<std::string, std::array<std::string, 5>> readTable(const std::filesystem::path& file) {
  std::map<std::string, std::array<std::string, 5>> rows;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);  // skips the header
  while (std::getline(in, line)) {
    std::stringstream fields(line);
    std::string cell;
    std::getline(fields, cell, ',');
    for (std::string& field : rows[cell]) std::getline(fields, field, ',');
  }
  return rows;
}

}  // namespace

TEST_CASE("the worm's lineage has the counts of the literature; both encodings give the same cells, fates and times") {
  const Run compact("lineage"), naive("lineage-naive");
  CHECK(compact.scenario.scene.dna.genes.size() == 830);
  CHECK(naive.scenario.scene.dna.genes.size() == 2569);
  for (const Run* run : {&compact, &naive}) {
    CAPTURE(run->scenario.scene.name);
    const Lineage& lineage = run->world.lineage;
    CHECK(lineage.entries.size() == 1341);
    CHECK(leavesOf(lineage, "") == Leaves{671, 113});
    CHECK(leavesOf(lineage, "A") == Leaves{487, 98});   // AB
    CHECK(leavesOf(lineage, "BAA") == Leaves{94, 14});  // MS
    CHECK(leavesOf(lineage, "BAB") == Leaves{20, 0});   // E
    CHECK(leavesOf(lineage, "BBA") == Leaves{48, 1});   // C
    CHECK(leavesOf(lineage, "BBBA") == Leaves{20, 0});  // D
    CHECK(leavesOf(lineage, "BBBB") == Leaves{2, 0});   // P4
    std::map<int, int> depths;
    for (const LineageEntry& cell : lineage.entries)
      if (cell.fate != Fate::divided) ++depths[cell.path.depth()];
    CHECK(depths == std::map<int, int>{{5, 2}, {7, 12}, {8, 37}, {9, 145}, {10, 379}, {11, 92}, {12, 4}});
  }
  const Lineage &a = compact.world.lineage, &b = naive.world.lineage;
  REQUIRE(a.entries.size() == b.entries.size());
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    REQUIRE(a.entries[i].path == b.entries[i].path);
    REQUIRE(a.entries[i].fate == b.entries[i].fate);
    REQUIRE(a.entries[i].born == b.entries[i].born);
  }
}

TEST_CASE("the worm's lineage is the published one, cell for cell: names, fates, tissues and directions") {
  const std::filesystem::path file = MORULA_SOURCE_DIR "/../shared/celegans/lineage.csv";
  if (!std::filesystem::exists(file)) {
    std::cout << "skipped: no table of the lineage at " << file.string() << '\n';
    return;
  }
  const auto table = readTable(file);
  const Run compact("lineage"), naive("lineage-naive");
  REQUIRE(table.size() == 1341);
  std::map<std::string, int> directions;
  for (std::size_t i = 0; i < compact.world.lineage.entries.size(); ++i) {
    const LineageEntry &cell = compact.world.lineage.entries[i], &alike = naive.world.lineage.entries[i];
    const std::string name = compact.scenario.names.of(cell.path).value_or("");
    CAPTURE(cell.path.text(), name);
    REQUIRE(table.contains(name));
    const auto& [parent, direction, end, tissue, minutes] = table.at(name);
    if (!cell.path.isEgg()) {
      CHECK(compact.scenario.names.of(cell.path.mother()).value_or("") == parent);
      const bool isB = cell.path.letter(cell.path.depth() - 1);
      CHECK(std::string(isB ? "prv" : "ald").find(direction) != std::string::npos);
      if (!isB) ++directions[direction];
    }
    CHECK(morula::name(cell.fate) == end);
    if (cell.fate == Fate::alive) {
      CHECK(compact.world.biology->describe(cell.state) == tissue);
      CHECK(naive.world.biology->describe(alike.state) == name);
    }
  }
  CHECK(directions == std::map<std::string, int>{{"a", 636}, {"d", 18}, {"l", 16}});
}
