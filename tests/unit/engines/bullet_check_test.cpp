// The metrics that compare a run with Bullet's, on shapes with known differences.
#include "engines/bullet_check.h"

#include <limits>

#include "catch.h"
#include "observation/measures.h"

using namespace morula;

namespace {

const std::string pair =
    "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 1}\n"
    "cells: [{at: [-0.96, 0, 0]}, {at: [0.96, 0, 0]}]\n"
    "physics: {mesh: {icosphere: 2}, contact: {}}\ncheck: {bullet: {margin: 0.05}}\n";

using Shapes = std::vector<std::vector<Point>>;

/// Returns the only result.
CheckResult compare(const World& world, const Shapes& shapes, const BulletCheck& check) {
  const auto results = compareWithBullet(world, shapes, check);
  REQUIRE(results.size() == 1);
  CHECK(results[0].kind == CheckKind::bullet);
  return results[0];
}

BulletCheck only(std::optional<double> BulletCheck::*metric, double tolerance) {
  BulletCheck check;
  check.margin = 0.05;
  check.*metric = tolerance;
  return check;
}

}  // namespace

TEST_CASE("Each metric sees what it is for, and of whom") {
  const World world = makeWorld(readScenario(pair, "pair.yaml", ".").scene);
  Shapes shapes = shapesOf(world);
  shapes[1][7].y += 0.25;
  const CheckResult positions = compare(world, shapes, only(&BulletCheck::positions, 0.2));
  CHECK(*positions.share == Approx(1.25));
  CHECK(positions.cell == "B");
  CHECK(!positions.passed);
  CHECK(positions.message.find("check.bullet.positions") != std::string::npos);

  shapes = shapesOf(world);
  for (Point& p : shapes[0]) p = Point{-1, 0, 0} + 1.1 * (p - Point{-1, 0, 0});
  CHECK(*compare(world, shapes, only(&BulletCheck::radius, 0.1)).share == Approx((0.1 / 1.1) / 0.1));
  CHECK(*compare(world, shapes, only(&BulletCheck::volume, 1)).share == Approx(1 - 1 / 1.331));
  CHECK(*compare(world, shapes, only(&BulletCheck::aspect, 1)).share == Approx(0).margin(1e-12));

  shapes = shapesOf(world);
  for (Point& p : shapes[1]) p.z *= 1.25;
  CHECK(*compare(world, shapes, only(&BulletCheck::aspect, 1)).share == Approx(1 - 1 / 1.25));
}

TEST_CASE("Distances of cells that touch are less by Bullet's gap of two margins") {
  const World world = makeWorld(readScenario(pair, "pair.yaml", ".").scene);
  REQUIRE(measureContacts(world).size() == 1);
  Shapes shapes = shapesOf(world);
  for (Point& p : shapes[1]) p.x += 0.1;
  CHECK(*compare(world, shapes, only(&BulletCheck::distance, 1)).share == Approx(0).margin(1e-12));
}

TEST_CASE("What is no number is off") {
  const World world = makeWorld(readScenario(pair, "pair.yaml", ".").scene);
  for (const std::size_t where : {0, 1}) {
    Shapes shapes = shapesOf(world);
    shapes[where][0].x = std::numeric_limits<double>::quiet_NaN();
    for (const auto metric : {&BulletCheck::positions, &BulletCheck::radius, &BulletCheck::volume,
                              &BulletCheck::distance, &BulletCheck::aspect})
      CHECK(!compare(world, shapes, only(metric, 1e9)).passed);
  }
}

TEST_CASE("Without tolerances those hold that fit the scene") {
  const auto of = [](std::string text, const std::string& from, const std::string& to) {
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return tolerancesFor(readScenario(text, "pair.yaml", "."));
  };
  CHECK(of(pair, "", "").distance == 0.01);
  CHECK(!of(pair, "", "").positions);
  const BulletCheck alone = of(pair, "contact: {}", "integrator: rk4");
  CHECK((alone.radius == 1e-6 && alone.volume == 1e-6 && !alone.distance && !alone.positions));
  CHECK(of(pair, "contact: {}", "integrator: thesis-verlet").positions == 1e-10);
  CHECK(of(pair, ", contact: {}", "").positions == 1e-10);  // velocity-verlet
  const BulletCheck implicit = of(pair, ", contact: {}}\ncheck: {bullet: {margin: 0.05}}",
                                  ", membrane: {springs: equal}}\ncheck: {bullet: {baseline: b3}}");
  CHECK(implicit.radius == 1e-8);
  const BulletCheck given = of(pair, "margin: 0.05", "aspect: 0.5");
  CHECK((given.aspect == 0.5 && !given.distance && !given.volume));
}
