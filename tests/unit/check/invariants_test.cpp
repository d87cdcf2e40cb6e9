// Invariants that a scenario's `check` observes.
#include "check/invariants.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "observation/body_measures.h"
#include "observation/energy.h"
#include "scenario/scenario.h"

using namespace morula;

namespace {

const std::string two =
    "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 1}\n"
    "cells: [{at: [-2, 0, 0], velocity: [3, 0, 0]}, {at: [2, 0, 0], scale: 0.5}]\n"
    "physics: {mesh: {icosphere: 1}, pressure: {constant: 0, outside: 1}}\n";

World worldOf(const std::string& text) { return makeWorld(readScenario(text, "two.yaml", ".").scene); }

CheckResult only(const CheckParameters& check, const World& world) {
  Invariants invariants(check);
  invariants.observe(world);
  const auto results = invariants.results(world);
  REQUIRE(results.size() == 1);
  CHECK(results[0].kind == CheckKind::invariant);
  return results[0];
}

template <class Set>
CheckResult with(const Set& set, const World& world) {
  CheckParameters check;
  set(check);
  CHECK(Invariants::areGiven(check));
  return only(check, world);
}

}  // namespace

TEST_CASE("Energy: motion by hand, nothing at rest, contents from the integral of their pressure") {
  World world = worldOf(two);
  Bodies& b = *world.bodies;
  // Contents without a pressure constant have the energy P0·V.
  CHECK(measureEnergy(b).total() == Approx(0.5 * 9 + b.volume[0] + b.volume[1]));
  CHECK(norm(measureMomentum(b) - Vector{3, 0, 0}) < 1e-12);
  // Differences test dE/dV = P0 − k/V, which follows from the pressure.
  b.pressureConstant[0] = 2;
  const double v = b.volume[0], h = 1e-4 * v;
  const auto energyAt = [&](double volume) {
    b.volume[0] = volume;
    return measureEnergy(b).total();
  };
  CHECK((energyAt(v + h) - energyAt(v - h)) / (2 * h) == Approx(1 - 2 / v).epsilon(1e-6));
  // At P0·V = k contents have no energy.
  b.velocity.assign(b.velocity.size(), 0);
  b.volume[0] = 2, b.volume[1] = 0;
  CHECK(measureEnergy(b).total() == Approx(0).margin(1e-12));
}

TEST_CASE("Energy: a membrane that is twice as long holds ½k·l² of every edge once, as strong as each is") {
  World world = worldOf(two);
  Bodies& b = *world.bodies;
  b.velocity.assign(b.velocity.size(), 0);
  b.volume[0] = b.volume[1] = 0;
  const MeshTemplate& mesh = b.mesh;
  double squares = 0;
  for (int e = 0; e < mesh.edgeCount(); ++e)
    squares += mesh.springWeights.at(e) * mesh.restLengths[e] * mesh.restLengths[e];
  for (int vertex = 0; vertex < b.vertexCount(); ++vertex)
    b.write(b.position, 0, vertex, 2.0 * mesh.mesh.vertices[vertex]);
  CHECK(measureEnergy(b).total() == Approx(0.5 * b.parameters.membrane.stiffness * squares));
}

TEST_CASE("Each check passes at its bound and fails a little beyond it") {
  const World world = worldOf(two);
  const double volume = world.bodies->volume[0] / world.bodies->volume[0];
  CHECK(with([&](auto& c) { c.volume = Bounds{volume - 1e-9, volume + 1e-9}; }, world).passed);
  CHECK(!with([&](auto& c) { c.volume = Bounds{volume + 1e-6, 2}; }, world).passed);
  CHECK(!with([&](auto& c) { c.volume = Bounds{0, volume - 1e-6}; }, world).passed);
  CHECK(with([](auto& c) { c.endVolume = Bounds{0.99, 1.01}; }, world).passed);
  CHECK(!with([](auto& c) { c.endVolume = Bounds{1.01, 2}; }, world).passed);
  CHECK(with([](auto& c) { c.extent = 3.05; }, world).passed);
  CHECK(!with([](auto& c) { c.extent = 3; }, world).passed);
  const double energy = measureEnergy(*world.bodies).total();
  CHECK(with([&](auto& c) { c.energy = energy; }, world).passed);
  CHECK(!with([&](auto& c) { c.energy = energy * 0.999; }, world).passed);
  CHECK(with([](auto& c) { c.endRoundness = 0.9; }, world).passed);
  CHECK(!with([](auto& c) { c.endRoundness = 0.999; }, world).passed);
  CHECK(with([](auto& c) { c.endOverlap = 0; }, world).passed);
}

TEST_CASE("Momentum is held against the start; a passing worst is remembered with its step and cell") {
  World world = worldOf(two);
  CheckParameters check;
  check.momentum = 0.5;
  check.volume = Bounds{0.5, 2};
  Invariants invariants(check);
  invariants.observe(world);
  Bodies& b = *world.bodies;
  world.clock.step = 7;
  b.velocity.assign(b.velocity.size(), 0);
  b.volume[1] *= 3;
  invariants.observe(world);
  world.clock.step = 8;
  b.volume[1] /= 3;
  invariants.observe(world);
  const auto results = invariants.results(world);
  REQUIRE(results.size() == 2);
  CHECK(results[0].check == "volume");
  CHECK(!results[0].passed);
  CHECK(results[0].firstStep == 7u);
  CHECK(results[0].cell == "B");
  CHECK(results[0].message.find("at step 7 of cell B") != std::string::npos);
  CHECK(results[1].check == "momentum");
  CHECK(!results[1].passed);
}

TEST_CASE("What is no number fails, also when numbers follow") {
  World world = worldOf(two);
  CheckParameters check;
  check.volume = Bounds{0, 1e9};
  Invariants invariants(check);
  const double volume = world.bodies->volume[0];
  world.bodies->volume[0] = NAN;
  invariants.observe(world);
  world.bodies->volume[0] = volume;
  invariants.observe(world);
  CHECK(!invariants.results(world)[0].passed);
}

TEST_CASE("Nothing is looked at unless it is asked for") {
  CHECK(!Invariants::areGiven({}));
  const World world = worldOf(two);
  Invariants invariants({});
  invariants.observe(world);
  CHECK(invariants.results(world).empty());
}

TEST_CASE("A run that must stop: all texts are in the reason, or it has not") {
  CHECK(stopsAsItMust({"springs", "physics.time_step"}, "physics.time_step 1 … of its springs").passed);
  CHECK(!stopsAsItMust({"springs", "contacts"}, "of its springs").passed);
  const auto well = stopsAsItMust({"springs"}, "");
  CHECK(!well.passed);
  CHECK(well.message.find("the run ended well") != std::string::npos);
}

TEST_CASE("A place that is no number breaks the extent, whichever vertex it is of, and holds no more") {
  for (const int vertex : {0, 5, 41}) {
    World world = worldOf(two);
    CheckParameters check;
    check.extent = 9;
    Invariants invariants(check);
    invariants.observe(world);
    CHECK(invariants.holdSoFar());
    Bodies& b = *world.bodies;
    b.write(b.position, 0, vertex, {0, std::numeric_limits<double>::quiet_NaN(), 0});
    invariants.observe(world);
    CHECK(!invariants.holdSoFar());
    CHECK(!invariants.watched()[0].passed);
    b.write(b.position, 0, vertex, {0, 0, 0});
    invariants.observe(world);
    CHECK(!invariants.holdSoFar());
  }
}
