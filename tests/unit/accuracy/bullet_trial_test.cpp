// Settings of trials in Bullet. Tests of runs in Bullet: tests/cli/accuracy_test.cpp.
#include "accuracy/bullet_trial.h"

#include <set>

#include "catch.h"

using namespace morula;

TEST_CASE("Bullet's margins and iterations are searched where they count") {
  CHECK(bulletChoices(Baseline::b1, false).size() == 1);
  CHECK(bulletChoices(Baseline::b1, true).size() == 16);
  CHECK(bulletChoices(Baseline::b2, false).size() == 4);  // numbers of iterations over B2's links
  CHECK(bulletChoices(Baseline::b3, false).size() == 1);
  std::set<std::string> names;
  for (const BulletSetting& s : bulletChoices(Baseline::b1, true)) names.insert(seriesName(s, true));
  CHECK(names.size() == 16);
  CHECK(names.contains("bullet b1, margin 0.01"));
  CHECK(names.contains("bullet b1, margin 0.0025, 4 iterations"));
}

TEST_CASE("Bullet's time steps: eight times ours down to the shortest, and the longest stable one too") {
  const std::vector<double> times{1, 2};
  CHECK(bulletTimeSteps(0.125, 0, 2, times) == std::vector<double>{1, 0.5, 0.25, 0.125, 0.0625, 0.03125});
  CHECK(bulletTimeSteps(0.125, 0.1, 0, times) == std::vector<double>{1, 0.5, 0.25, 0.125});  // 0.1 < 0.125
  const auto steps = bulletTimeSteps(0.125, 1.0 / 6, 0, times);
  REQUIRE(steps.size() == 5);
  CHECK(steps[3] == static_cast<float>(1.0 / 6));  // Bullet takes floats
}

TEST_CASE("A run is beaten by one that is as exact and faster; one without an error is") {
  CHECK(unbeaten({0.1, 0.01, 0.1, {}, 0.05}, {1, 5, 2, 0.1, 6}) == std::vector<bool>{true, true, false, false, false});
}
