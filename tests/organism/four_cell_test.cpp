// The diamond of the worm's four cells: nearly every seed gives it with the embryo's properties, and not without.
#include <iostream>

#include "catch.h"
#include "organism/four_cells.h"

using namespace four_cells;

namespace {

/// Returns true for five contacts above 5 % of the mean, with ABa (AA) and P2 (BB) apart, 1.8 to 2.0 times as far as
/// ABa and ABp.
bool isDiamond(const Arrangement& a) {
  for (const char* pair : {"AA-AB", "AA-BA", "AB-BA", "AB-BB", "BA-BB"})
    if (!a.contact.contains(pair) || a.contact.at(pair) <= 0.05) return false;
  const double ratio = a.distance.at("AA-BB") / a.distance.at("AA-AB");
  return !a.contact.contains("AA-BB") && ratio >= 1.8 && ratio <= 2.0;
}

int diamonds(int seeds, const std::vector<std::string>& changes) {
  const auto all = runSeeds("worm/four-cell.yaml", seeds, changes);
  return static_cast<int>(std::ranges::count_if(all, isDiamond));
}

}  // namespace

TEST_CASE("four cells: the worm's diamond, in at least 19 of 20 seeds") {
  const int found = diamonds(20, {});
  CAPTURE(found);
  CHECK(found >= 19);
}

TEST_CASE("four cells: neither the longest extent nor chance makes the diamond") {
  CHECK(diamonds(5, {"division.rules=null", "division.plane=longest"}) == 0);
  CHECK(diamonds(5, {"division.rules=null", "division.plane=random"}) <= 1);
}

TEST_CASE("four cells: what the shell and the volumes do") {
  const int noShell = diamonds(5, {"physics.shell=null"}),
            sphere = diamonds(5, {"physics.shell={sphere: 1, fill: 0.87}"});
  const std::string equal =
      "division.rules=[{of: P0, axis: [-1, 0, 0], tilt: 10}, {of: AB, axis: [-0.4, -0.92, 0], tilt: 10}, "
      "{of: P1, axis: [-0.5, -0.87, 0], tilt: 10}]";
  const int equalVolumes = diamonds(5, {equal});
  std::cout << "diamonds of 5: without a shell " << noShell << ", in a sphere " << sphere << ", of equal volumes "
            << equalVolumes << '\n';
  CHECK(noShell == 0);
  CHECK(sphere == 0);
}
