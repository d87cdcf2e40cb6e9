// A line of descent that outgrows the paths of cells is told before the run.
#include "helpers.h"
#include "simulation/simulation.h"

using namespace morula;
using namespace morula::test;

namespace {

/// A stem cell, which divides in every cycle while its daughter B dies.
constexpr const char* stem = "\n  START: s\n  keep(s|s, !B)\n  div(divide|s, !B)\n  gone(die|s, B)";

std::vector<std::string> warningsOf(const std::string& dna, const std::string& rest) {
  return read("morula: 1\nname: stem\ndna: |" + dna + "\n" + rest).warnings;
}

bool isTold(const std::vector<std::string>& warnings) {
  return std::ranges::any_of(warnings, [](const auto& w) { return w.find("on its line of descent") < w.size(); });
}

}  // namespace

TEST_CASE("A stem cell that divides more often than a path can hold is told with the time, which the run meets") {
  const auto warnings = warningsOf(stem, "stop: {time: 130}\n");
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0],
             Catch::Contains("stop: a cell divides for the 121st time on its line of descent at time 121,"));
  World world = makeWorld(read("morula: 1\nname: stem\ndna: |" + std::string(stem) + "\nstop: {time: 130}\n").scene);
  const auto toEnd = [&] {
    while (!finished(world)) step(world);
  };
  CHECK_THROWS_WITH(toEnd(), Catch::Contains("at most 120 divisions"));
  CHECK(world.clock.time == Approx(121));
}

TEST_CASE("Nothing is told of lines that end, are slow enough, or are not known before the run") {
  CHECK_FALSE(isTold(warningsOf(stem, "stop: {time: 120.5}\n")));
  CHECK_FALSE(isTold(warningsOf(stem, "stop: {time: 130}\ncycle: {length: 2}\n")));
  CHECK_FALSE(isTold(warningsOf(stem, "stop: {time: 130, cells: 3}\n")));
  CHECK_FALSE(isTold(warningsOf("\n  START: s\n  a(t|s)\n  d(divide|s)\n  b(t|t)", "stop: {time: 1000}\n")));
  // Every other cycle passes without a division.
  const std::string slow = "\n  START: s\n  w(w|s, !B)\n  v(s|w)\n  d(divide|w)\n  gone(die|s, B)";
  CHECK_FALSE(isTold(warningsOf(slow, "stop: {time: 240}\n")));
  CHECK(isTold(warningsOf(slow, "stop: {time: 250}\n")));
  CHECK(isTold(warningsOf(stem, "stop: {time: 70}\ncycle: {length: 1, per-substance: {divide: 0.5}}\n")));
}
