// The shape of the shell decides the arrangement of the worm's four cells [Yamamoto & Kimura 2017].
#include <fstream>
#include <iostream>
#include <iterator>

#include "catch.h"
#include "organism/four_cells.h"

using namespace four_cells;

namespace {

/// Returns the number of seeds with each arrangement, in a spheroid `aspect` times as long as wide.
std::map<std::string, int> arrangements(double aspect, int seeds, const std::string& adhesion) {
  std::vector<std::string> changes{"physics.shell.ellipsoid=[" + std::to_string(aspect) + ", 1, 1]"};
  if (!adhesion.empty()) changes.push_back("physics.contact.adhesion=" + adhesion);
  std::map<std::string, int> found;
  for (const Arrangement& a : runSeeds("worm/shell-shapes.yaml", seeds, changes)) ++found[a.name];
  std::cout << "aspect " << aspect << (adhesion.empty() ? "" : ", adhesion " + adhesion) << ':';
  for (const auto& [name, count] : found) std::cout << ' ' << name << ' ' << count;
  std::cout << '\n';
  return found;
}

}  // namespace

TEST_CASE("shell shapes: tetrahedra and diamonds in a round shell, the diamond in a long one, the line in a longer one") {
  constexpr int seeds = 4;
  auto round = arrangements(1, seeds, "");
  CHECK(round["tetrahedron"] + round["diamond"] == seeds);
  CHECK(arrangements(1.75, seeds, "")["diamond"] == seeds);
  CHECK(arrangements(2.5, seeds, "")["linear"] == seeds);
  CHECK(arrangements(2.25, seeds, "2")["diamond"] > arrangements(2.25, seeds, "")["diamond"]);
}

TEST_CASE(
    "shell shapes in all seeds: from the tetrahedron over the diamond to the line, as the shell gets longer; cells that stick keep "
    "the diamond in longer shells",
    "[.][all-seeds]") {
  constexpr int seeds = 20;
  const auto at = [&](double aspect, const std::string& adhesion = "") {
    return arrangements(aspect, seeds, adhesion);
  };
  auto round = at(1), oval = at(1.25);
  CHECK(round["tetrahedron"] + round["diamond"] == seeds);
  CHECK(round["tetrahedron"] > seeds / 2);
  CHECK(oval["tetrahedron"] > 0);
  CHECK(oval["diamond"] > 0);
  for (const double aspect : {1.5, 1.75, 2.0}) CHECK(at(aspect)["diamond"] >= seeds - 1);
  auto between = at(2.25), longer = at(2.5);
  CHECK(between["T"] > 0);
  CHECK(between["diamond"] < seeds);
  CHECK(between["linear"] < seeds);
  CHECK(longer["linear"] == seeds);
  CHECK(at(3)["linear"] == seeds);
  auto sticky = at(2.25, "1"), stickier = at(2.25, "2");
  CHECK(sticky["diamond"] > between["diamond"]);
  CHECK(stickier["diamond"] > sticky["diamond"]);
  CHECK(stickier["diamond"] >= seeds / 2);
  // The scenario's head comment states these counts.
  std::ifstream file(MORULA_SOURCE_DIR "/scenarios/worm/shell-shapes.yaml");
  const std::string head{std::istreambuf_iterator<char>(file), {}};
  const auto told = [&](const std::string& before, int count, const std::string& after) {
    CHECK_THAT(head, ContainsSubstring(before + std::to_string(count) + after));
  };
  told("wide, ", round["tetrahedron"], " tetrahedra and " + std::to_string(round["diamond"]) + " diamonds;");
  told("long, ", oval["tetrahedron"], " tetrahedra and " + std::to_string(oval["diamond"]) + " diamonds;");
  told("at 2.25, ", between["diamond"], " diamond, " + std::to_string(between["T"]) + " T and ");
  told(" T and ", between["linear"], " lines;");
  told("adhesion of 1, ", sticky["diamond"], " diamonds, and ");
  told("adhesion of 2, ", stickier["diamond"], " diamonds;");
}
