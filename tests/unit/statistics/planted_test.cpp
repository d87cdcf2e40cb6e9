// Planted effects in simulated organisms: real effects are found, and false ones about as often as the test's level
// says.
//
// The scene has one line of descent that divides, on the side of daughter A in one policy and of daughter B in the
// other. The outcome is the time of its second division: the cycle of the egg, which both policies share under one
// seed, and the cycle of its daughter, whose deviation belongs to another lineage path. So the policies are
// statistically equal, but not bit for bit, and seeds pair them as any two policies (the correlation is ½). The planted
// effect is a policy whose cycles are longer by a standard deviation of the outcome.
//
// Seeds are fixed, so the numbers are always the same. Of 200 repetitions at a level of 5 %, ten false effects are
// expected with a standard deviation of 3.1. Four in five choices of seeds give 6 to 14, these among them. A later test
// checks the level itself with more repetitions.
#include <array>
#include <cmath>

#include "catch.h"
#include "scenes.h"
#include "statistics/means.h"

using namespace morula;

namespace {

constexpr std::size_t n = 20;
constexpr int repetitions = 200;

/// Returns the time of the line's second division. [time]
double outcome(bool onSideB, double length, std::uint64_t seed) {
  Scene scene = scenes::lineageOnly(
      std::string("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(divide|a1,") + (onSideB ? "B" : "A") + ")\n", 4);
  scene.seed = seed;
  scene.cycle.length = length;
  scene.variation.cycle = 0.1;
  scene.stop.cells = 3;
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  REQUIRE(world.cells.path.size() == 3);
  return world.clock.time;
}

using Sample = std::array<double, n>;

Sample sampleOf(bool onSideB, double length, std::uint64_t firstSeed) {
  Sample values;
  for (std::size_t i = 0; i < n; ++i) values[i] = outcome(onSideB, length, firstSeed + i);
  return values;
}

/// Returns the length of cycles with which the outcome is a standard deviation later.
double shiftedLength() {
  std::vector<double> values;
  for (std::uint64_t seed = 1'000'000; seed < 1'001'000; ++seed) values.push_back(outcome(false, 1, seed));
  return 1 + std::sqrt(variance(values)) / mean(values);
}

double share(int found, int of = repetitions) { return double(found) / of; }

}  // namespace

TEST_CASE("A planted effect of one standard deviation is found with 20 seeds in 95 % of 200 studies and more") {
  const double length = shiftedLength();
  CHECK(length == Approx(1 + std::sqrt(2.) * 0.1 * 0.9866 / 2).epsilon(0.06));  // two cycles, each with 10 %
  int found = 0, unpaired = 0;
  for (int r = 0; r < repetitions; ++r) {
    const auto a = sampleOf(false, 1, 1 + n * r), b = sampleOf(true, length, 1 + n * r);
    found += comparePaired(a, b).p < 0.05;
    unpaired += compareUnpaired(a, b).p < 0.05;
  }
  INFO("found " << found << " of 200, unpaired " << unpaired);
  CHECK(share(found) >= 0.95);
  CHECK(share(unpaired) < 0.95);  // common random numbers pay: without pairs 20 seeds are too few
}

TEST_CASE("Two copies of one policy are told apart in 3 to 7 % of 200 studies") {
  int found = 0;
  for (int r = 0; r < repetitions; ++r)
    found += comparePaired(sampleOf(false, 1, 1 + n * r), sampleOf(true, 1, 1 + n * r)).p < 0.05;
  INFO("told apart " << found << " of 200");
  CHECK(share(found) >= 0.03);
  CHECK(share(found) <= 0.07);
}

TEST_CASE("Of many studies of two copies one in twenty tells them apart, paired or with seeds of their own") {
  int paired = 0, unpaired = 0;
  const int many = 2000;
  for (int r = 0; r < many; ++r) {
    const auto a = sampleOf(false, 1, 200'000 + n * r);
    paired += comparePaired(a, sampleOf(true, 1, 200'000 + n * r)).p < 0.05;
    unpaired += compareUnpaired(a, sampleOf(false, 1, 300'000 + n * r)).p < 0.05;
  }
  INFO("paired " << paired << ", unpaired " << unpaired << " of 2000");
  CHECK(share(paired, many) == Approx(0.05).margin(0.015));  // three standard deviations of the count
  CHECK(share(unpaired, many) == Approx(0.05).margin(0.015));
}

TEST_CASE("One policy twice under the same seeds is the same bits, and nothing is told apart") {
  const auto a = sampleOf(false, 1, 1);
  CHECK(a == sampleOf(false, 1, 1));
  CHECK(comparePaired(a, a).p == 1);
}
