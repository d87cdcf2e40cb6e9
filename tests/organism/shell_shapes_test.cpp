// The shape of the shell decides how the worm's four cells lie [Yamamoto & Kimura 2017]. Six seeds for each shape in
// every test run; 20 with: test_organism "[more]"
#include <cmath>
#include <iostream>

#include "catch.h"
#include "organism/four_cells.h"

using namespace four_cells;

namespace {

/// How many of the seeds lie so, in a spheroid that is so many times as long as wide.
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

void checkSeries(int seeds) {
  const auto at = [&](double aspect) { return arrangements(aspect, seeds, ""); };
  auto round = at(1);
  CHECK(round["tetrahedron"] > 0);
  CHECK(round["tetrahedron"] + round["diamond"] == seeds);
  CHECK(at(1.5)["diamond"] == seeds);
  CHECK(at(1.75)["diamond"] >= seeds - 1);
  auto between = at(2.25);
  CHECK(between["diamond"] < seeds);
  CHECK(between["linear"] < seeds);
  CHECK(at(3)["linear"] == seeds);
}

}  // namespace

TEST_CASE("shell shapes: from the tetrahedron over the diamond to the line, as the shell gets longer") { checkSeries(6); }
TEST_CASE("shell shapes: the same with 20 seeds a shape", "[.][more]") { checkSeries(20); }
