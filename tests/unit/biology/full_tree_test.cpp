#include "biology/full_tree.h"

#include "catch.h"
#include "organism.h"
#include "temporary_folder.h"

using namespace morula;

TEST_CASE("the tree of C. elegans [Nilsson 2008, 5.2.3]: 4094 genes, 1024 unique final cells") {
  const std::string text = makeFullTreeDna(10);
  CHECK(parseDna(text, "f").genes.size() == 4094);

  Organism organism(text);
  for (int division = 1; division <= 10; ++division) {
    organism.runCellCycle();
    CHECK(organism.size() == std::size_t{1} << division);
    if (division == 7) CHECK(organism.size() == 128);
  }
  organism.runCellCycle();
  const auto cells = organism.cells();
  CHECK(cells.size() == 1024);
  CHECK(organism.census().size() == 1024);
  for (int cycle = 0; cycle < 3; ++cycle) {
    organism.runCellCycle();
    CHECK(organism.cells() == cells);
  }
}

TEST_CASE("a prefix of the final substance tells the founder") {
  Organism organism(makeFullTreeDna(6));
  for (int cycle = 0; cycle < 7; ++cycle) organism.runCellCycle();
  for (const auto& [path, substance] : organism.cells()) {
    const std::string founder = path[0] == 'A' ? "AB" : path.starts_with("BA") ? "EMS" : "P2";
    std::string expected = founder;
    for (char c : path.substr(founder == "AB" ? 1 : 2)) expected += c == 'A' ? 'a' : 'b';
    CHECK(substance == expected);
  }
}

TEST_CASE("the shipped file is what the generator writes") {
  const std::string shipped = readText(MORULA_SOURCE_DIR "/scenarios/thesis/elegans-1024.dna");
  CHECK((shipped == makeFullTreeDna(10)));  // parentheses keep 120 kB from being printed
}

TEST_CASE("trees of other sizes") {
  for (int levels = 1; levels <= 5; ++levels) {
    const std::string text = makeFullTreeDna(levels);
    const std::size_t leaves = std::size_t{1} << levels;
    CHECK(parseDna(text, "f").genes.size() == 4 * leaves - 2);
    Organism organism(text);
    for (int cycle = 0; cycle <= levels; ++cycle) organism.runCellCycle();
    CHECK(organism.census().size() == leaves);
  }
  CHECK_THROWS_AS(makeFullTreeDna(0), InputError);
  CHECK_THROWS_AS(makeFullTreeDna(17), InputError);
}
