// Frames of a run: positions of the promised precision, evenly spaced in time, thinned from the front. Their forces add
// up to mass times acceleration, and measuring them changes nothing.
#include "report_data/frames.h"

#include <bit>
#include <cmath>

#include "catch.h"
#include "files/bytes.h"
#include "loop/simulate.h"
#include "observation/measures.h"
#include "simulation/move_physics.h"
#include "simulation/simulation.h"

namespace morula {
namespace {

const std::string plain = "{mesh: {icosphere: 1}, contact: {}}";
const std::string tissue =
    "{mesh: {icosphere: 1}, cell: {radius: 0.95}, shell: {sphere: 1}, drag: 1, contact: {adhesion: {default: 0.5}}}";
const std::string spheres = "{cell: {model: sphere}, drag: 1, contact: {}}";
const std::string solved = "{mesh: {icosphere: 1}, integrator: xpbd, contact: {}}";

Scenario sceneWith(const std::string& physics) {
  return readScenario("morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.25}\nphysics: " +
                          physics + "\ndivision: {plane: {axis: [1, 0, 0]}}\nconnections: {make: at-division}\n",
                      "two.yaml", "");
}

struct Watched {
  Simulation run;
  Frames frames;
};

Watched watch(const std::string& physics, std::size_t most, bool forces = false) {
  const Scenario scenario = sceneWith(physics);
  std::optional<ForceMeter> meter;
  if (forces) meter.emplace(makeScenarioWorld(scenario, {}));
  FrameTaker taker(1.25, most, std::move(meter));
  auto run = simulate(scenario, Execution{}, {.watch = {&taker}});
  return {std::move(run), std::move(taker.frames())};
}

float floatAt(const std::string& bytes, std::size_t at) {
  return std::bit_cast<float>(numberAt<std::uint32_t>(bytes, at));
}

Vector vectorAt(const std::string& bytes, std::size_t at) {
  return {floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8)};
}

/// Returns the place in a frame's bytes behind its contacts and connections.
std::size_t behindPairs(const Frames& frames, const Frame& frame) {
  return 4 * (7 + frames.measures.size()) * frame.cells + 12 * frame.contacts + 8 * frame.connections;
}

}  // namespace

TEST_CASE("Frames lie evenly over time, the first at the start and the last at the end") {
  const auto [run, frames] = watch(plain, 6);
  REQUIRE(run.end.status == RunStatus::done);
  REQUIRE(frames.frames.size() == 6);
  for (std::size_t k = 0; k < 6; ++k) CHECK(frames.frames[k].time == Approx(0.25 * double(k)).margin(0.02));
  CHECK(frames.frames[0].time == 0);
  CHECK(frames.frames[5].time == run.end.time);
  CHECK(frames.frames[3].cells == 1);
  CHECK(frames.frames[5].cells == 2);
  CHECK(frames.frames[5].connections == 1);
  CHECK(frames.worlds.size() == 6);
}

TEST_CASE("A frame holds measures, and positions within half a step") {
  const auto [run, frames] = watch(plain, 2);
  const Frame& last = frames.frames.back();
  const std::size_t words = 7 + frames.measures.size(), vertices = 42;
  constexpr double radius = 1;  // [length] of the egg
  REQUIRE(frames.meshes.size() == 1);
  REQUIRE(last.cells == 2);
  const auto cells = measureCells(run.world);
  std::size_t places = behindPairs(frames, last);
  REQUIRE(last.bytes.size() == (places + 6 * vertices * last.cells + 3) / 4 * 4);
  for (std::size_t i = 0; i < last.cells; ++i) {
    const std::size_t at = 4 * words * i;
    CHECK(run.world.lineage.entries[numberAt<std::uint32_t>(last.bytes, at)].path == run.world.cells.path[i]);
    for (std::size_t m = 0; m < frames.measures.size(); ++m)
      if (const auto& value = cells[i].values[m])
        CHECK(floatAt(last.bytes, at + 28 + 4 * m) == Approx(*value).epsilon(std::ldexp(1, -16)).margin(0));
    CHECK(floatAt(last.bytes, at + 24) <= 2 * radius / 2048);  // a cell's longest side is less than two radii of the egg
    for (const Point& p : cellVertices(run.world, run.world.cells.path[i]))
      for (std::size_t axis = 0; axis < 3; ++axis, places += 2) {
        const double step = floatAt(last.bytes, at + 24);
        const auto number = numberAt<std::uint16_t>(last.bytes, places);
        const double exact = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
        CHECK(std::abs(floatAt(last.bytes, at + 12 + 4 * axis) + step * number - exact) <= 0.5 * step);
      }
  }
}

TEST_CASE("What does not fit is thinned, and the last frame stays longest") {
  auto frames = watch(plain, 9).frames;
  const std::size_t all = packedFrames(frames).size();
  thinFrames(frames, all);
  CHECK(frames.frames.size() == 9);
  const double last = frames.frames.back().time;
  thinFrames(frames, all - 1);
  CHECK(frames.frames.size() == 8);
  CHECK(packedFrames(frames).size() < all);
  CHECK(frames.frames.front().time == 0);
  CHECK(frames.frames.back().time == last);
  auto one = frames;
  one.frames.erase(one.frames.begin(), one.frames.end() - 1);
  thinFrames(frames, packedFrames(one).size());
  REQUIRE(frames.frames.size() == 1);
  CHECK(frames.frames.back().time == last);
  thinFrames(frames, 10);
  CHECK(frames.frames.empty());
  CHECK(frames.worlds.size() == 9);
}

TEST_CASE("What a frame keeps of a cell's forces adds up to its mass times acceleration") {
  for (const std::string& physics : {tissue, spheres}) {
    CAPTURE(physics);
    auto [run, frames] = watch(physics, 4, true);
    const Frame& last = frames.frames.back();
    REQUIRE(last.cells == 2);
    evaluateForces(run.world);
    const Bodies& bodies = *run.world.bodies;
    std::size_t at = behindPairs(frames, last);
    for (const int slot : bodies.slots) {
      Vector net, kept;
      double sizes = 0;
      for (int v = 0; v < bodies.vertexCount(slot); ++v)
        net += bodies.vertexMass[slot] * bodies.read(bodies.acceleration, slot, v);
      for (std::size_t k = 0; k < kindsWithNetForce(frames.forces).size(); ++k, at += 12) {
        const Vector force = vectorAt(last.bytes, at);
        kept += force, sizes += norm(force);
      }
      CHECK(sizes > 0);
      // Tolerance: each kind is rounded by 2^-16 of its size, and the sums over vertices are rounded.
      CHECK(norm(kept - net) <= std::ldexp(sizes, -16) + 1e-12);
    }
  }
}

TEST_CASE("Forces on vertices are kept of the last frame, to half a step") {
  auto [run, frames] = watch(tissue, 4, true);
  CHECK(frames.frames.front().vertexForces == 0);
  const Frame& last = frames.frames.back();
  REQUIRE(last.vertexForces > 0);
  const auto forces = forcesByKind(run.world);
  const std::size_t kinds = frames.forces.size();
  REQUIRE(kinds == 6);
  std::size_t steps = last.vertexForces, numbers = steps + 4 * kinds * forces.size();
  for (const ForcesByKind& cell : forces)
    for (std::size_t k = 0; k < kinds; ++k, steps += 4) {
      const double step = floatAt(last.bytes, steps);
      for (const Vector& force : cell[std::size_t(frames.forces[k])])
        for (const double exact : {force.x, force.y, force.z}) {
          double kept = 0;
          if (step > 0) kept = step * static_cast<std::int8_t>(last.bytes.at(numbers)), ++numbers;
          CHECK(std::abs(kept - exact) <= 0.5 * step * (1 + 1e-6) + 1e-7);
        }
    }
  CHECK(last.bytes.size() == (numbers + 3) / 4 * 4);
}

TEST_CASE("Spheres have a force on the whole, and integrators that solve for forces have none") {
  const Frames ofSpheres = watch(spheres, 4, true).frames;
  CHECK(ofSpheres.frames.back().vertexForces == 0);
  CHECK(ofSpheres.forces == std::vector{ForceKind::contact, ForceKind::adhesion, ForceKind::other});
  const Frames ofSolved = watch(solved, 4, true).frames;
  CHECK(ofSolved.forces.empty());
  CHECK(ofSolved.frames.back().vertexForces == 0);
}

TEST_CASE("A run whose forces are measured ends in the same bits") {
  const auto with = watch(tissue, 4, true), without = watch(tissue, 4);
  REQUIRE(with.run.end.stateHash);
  CHECK(with.run.end.stateHash->text() == without.run.end.stateHash->text());
  CHECK(without.frames.forces.empty());
  CHECK(with.frames.frames.back().bytes.size() > without.frames.frames.back().bytes.size());
}

}  // namespace morula
