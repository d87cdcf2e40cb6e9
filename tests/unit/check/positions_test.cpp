// Remarks on a run whose reference has positions in another unit, or mirrored ones.
#include <fmt/format.h>

#include "catch.h"
#include "check/remarks.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

using namespace morula;

namespace {

const std::vector<Point> places{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}, {0, 0, 11},
                                {4, 6, 1}, {9, 2, 3}, {1, 8, 8}, {7, 7, 7}};

/// Returns the remark on eight cells whose reference is `places` times `factor`, and times `mirror` along x.
std::string remark(double factor, double mirror, const std::string& measures = "position_rmsd, position_shape_rmsd") {
  std::string cells, positions;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point& p = places[i];
    cells += fmt::format("{}{{at: [{}, {}, {}]}}", i ? ", " : "", p.x, p.y, p.z);
    positions += fmt::format("{}{}{}{}: [{}, {}, {}]", i ? ", " : "", i & 4 ? 'B' : 'A', i & 2 ? 'B' : 'A',
                             i & 1 ? 'B' : 'A', factor * mirror * p.x, factor * p.y, factor * p.z);
  }
  const Scenario scenario = readScenario(
      "morula: 1\nname: s\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 1}\nphysics: {cell: {model: sphere}, drag: 1}\n"
      "cells: [" +
          cells + "]\nrecord: {measures: [" + measures + "]}\ncheck: {reference: {positions: {" + positions + "}}}\n",
      "s.yaml", "");
  return positionsText(makeWorld(scenario.scene), scenario);
}

}  // namespace

TEST_CASE("positions in another unit, and mirrored ones, are told; others are not") {
  CHECK(remark(1, 1) == "");
  CHECK(remark(1.9, 1) == "");
  CHECK_THAT(remark(57, 1), ContainsSubstring("lie 57 times as far apart as the cells"));
  CHECK_THAT(remark(0.01, 1), ContainsSubstring("lie 0.01 times as far apart"));
  CHECK(remark(57, 1, "position_shape_rmsd") == "");
  CHECK_THAT(remark(1, -1), ContainsSubstring("the mirror image of the cells fits check.reference.positions better"));
}
