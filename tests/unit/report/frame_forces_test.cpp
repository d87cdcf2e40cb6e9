// Forces in frames: they add up to mass times acceleration, and measuring them changes nothing.

#include <bit>
#include <cmath>

#include "catch.h"
#include "loop/simulate.h"
#include "report_data/frames.h"
#include "simulation/stages.h"

namespace morula {
namespace {

const std::string tissue =
    "{mesh: {icosphere: 1}, cell: {radius: 0.95}, shell: {sphere: 1}, drag: 1, contact: {adhesion: {default: 0.5}}}";
const std::string spheres = "{cell: {model: sphere}, drag: 1, contact: {}}";
const std::string solved = "{mesh: {icosphere: 1}, integrator: xpbd, contact: {}}";

Scenario sceneWith(const std::string& physics) {
  return readScenario("morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.25}\nphysics: " +
                          physics + "\ndivision: {plane: {axis: [1, 0, 0]}}\nconnections: {make: at-division}\n",
                      "two.yaml", "");
}

struct WatchedForces {
  Simulation run;
  Frames frames;
};

WatchedForces watch(const std::string& physics, bool forces = true) {
  const Scenario scenario = sceneWith(physics);
  std::optional<ForceMeter> meter;
  if (forces) meter.emplace(makeScenarioWorld(scenario, {}));
  FrameTaker taker(1.25, 4, std::move(meter));
  auto run = simulate(scenario, Execution{}, {.watch = [&](const World& w) { taker.observe(w); }});
  return {std::move(run), std::move(taker.frames())};
}

std::uint32_t wordAt(const std::string& bytes, std::size_t at, int size = 4) {
  std::uint32_t number = 0;
  for (int i = size - 1; i >= 0; --i)
    number = number << 8 | static_cast<unsigned char>(bytes.at(at + static_cast<std::size_t>(i)));
  return number;
}

float floatAt(const std::string& bytes, std::size_t at) { return std::bit_cast<float>(wordAt(bytes, at)); }

Vector vectorAt(const std::string& bytes, std::size_t at) {
  return {floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8)};
}

std::size_t netForcesAt(const Frames& frames, const Frame& frame) {
  return 4 * (9 + frames.measures.size()) * frame.cells + 12 * frame.contacts + 8 * frame.connections;
}

}  // namespace

TEST_CASE("What a frame keeps of a cell's forces adds up to its mass times acceleration") {
  for (const std::string& physics : {tissue, spheres}) {
    CAPTURE(physics);
    auto [run, frames] = watch(physics);
    const Frame& last = frames.frames.back();
    REQUIRE(last.cells == 2);
    evaluateForces(run.world);
    const Bodies& bodies = *run.world.bodies;
    std::size_t at = netForcesAt(frames, last);
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
      // Each kind is rounded to float: 2^-24 of its size, and rounding of the sums over vertices beside it.
      CHECK(norm(kept - net) <= 6e-8 * 2 * sizes + 1e-12);
    }
  }
}

TEST_CASE("Forces on vertices are kept of the last frame, to half a step") {
  auto [run, frames] = watch(tissue);
  CHECK(frames.frames.front().vertexForces == 0);
  const Frame& last = frames.frames.back();
  REQUIRE(last.vertexForces > 0);
  const auto forces = forcesByKind(run.world);
  const std::size_t kinds = frames.forces.size();
  REQUIRE(kinds == 6);
  std::size_t steps = last.vertexForces, numbers = steps + 4 * kinds * forces.size();
  for (const ForcesByKind& cell : forces)
    for (std::size_t k = 0; k < kinds; ++k, steps += 4) {
      const auto& onVertex = cell[std::size_t(frames.forces[k])];
      const double step = floatAt(last.bytes, steps);
      for (const Vector& force : onVertex) {
        for (const double exact : {force.x, force.y, force.z}) {
          double kept = 0;
          if (step > 0) kept = step * static_cast<std::int8_t>(wordAt(last.bytes, numbers, 1)), ++numbers;
          CHECK(std::abs(kept - exact) <= 0.5 * step * (1 + 1e-6) + 1e-7);
        }
      }
    }
  CHECK(last.bytes.size() == (numbers + 3) / 4 * 4);
}

TEST_CASE("Spheres have a force on the whole, and integrators that solve for forces have none") {
  const Frames ofSpheres = watch(spheres).frames;
  CHECK(ofSpheres.frames.back().vertexForces == 0);
  CHECK(ofSpheres.forces == std::vector{ForceKind::contact, ForceKind::adhesion, ForceKind::other});
  const Frames ofSolved = watch(solved).frames;
  CHECK(ofSolved.forces.empty());
  CHECK(ofSolved.frames.back().vertexForces == 0);
}

TEST_CASE("A run whose forces are measured ends in the same bits") {
  const auto with = watch(tissue), without = watch(tissue, false);
  REQUIRE(with.run.end.stateHash);
  CHECK(with.run.end.stateHash->text() == without.run.end.stateHash->text());
  CHECK(without.frames.forces.empty());
  CHECK(with.frames.frames.back().bytes.size() > without.frames.frames.back().bytes.size());
}

}  // namespace morula
