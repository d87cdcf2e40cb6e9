// Two minimisers of the same energy end in the same state: damped motion, and nonlinear conjugate gradients [Polak and Ribière
// 1969] of all cells at once, with line searches by the secant of forces. They share only the forces.
//
// The test compares positions of vertices, of taut cells pressed together by a shell with three different axes. Slack
// membranes, and cells with more room, have further states of rest nearby with other energies, where the minimisers may
// disagree.
#include "catch.h"
#include "observation/energy.h"
#include "simulation/move_physics.h"
#include "simulation/settle.h"
#include "worlds.h"

using namespace morula;

namespace {

using Field = std::vector<Vector>;  // [cell][vertex]

double product(const Field& a, const Field& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
  return sum;
}

double rms(const Field& a) { return std::sqrt(product(a, a) / static_cast<double>(a.size())); }

double farthest(const Field& a, const Field& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, norm(a[i] - b[i]));
  return most;
}

Field placesOf(const World& world) {
  Field places;
  for (int slot : world.bodies->slots)
    for (int v = 0; v < world.bodies->vertexCount(slot); ++v) places.push_back(world.bodies->vertex(slot, v) - Point{});
  return places;
}

Field forcesOf(const World& world) {
  const Bodies& b = *world.bodies;
  Field forces;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v)
      forces.push_back(b.vertexMass[slot] * b.read(b.acceleration, slot, v));
  return forces;
}

/// Moves vertices `length` times the direction away from `from`, or as far as the shell lets them.
void moveAlong(World& world, const Field& from, const Field& direction, double length) {
  Bodies& b = *world.bodies;
  std::size_t i = 0;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v, ++i) {
      b.write(b.position, slot, v, from[i] + length * direction[i]);
      b.write(b.velocity, slot, v, {});
    }
  evaluateForces(world);
}

/// Minimises until the root mean square of forces is at most `force`; returns false after 5000 lines without success.
bool conjugateGradients(World& world, double force) {
  evaluateForces(world);
  Field forces = forcesOf(world), direction = forces;
  double length = 1e-3;
  for (int line = 0; line < 5000; ++line) {
    const double squares = product(forces, forces);
    if (std::sqrt(squares / static_cast<double>(forces.size())) <= force) return true;
    if (!(product(direction, forces) > 0)) direction = forces;
    const double slope = product(direction, forces);
    const Field places = placesOf(world);
    const double trial = std::min(length, 0.01 / rms(direction));
    moveAlong(world, places, direction, trial);
    const double there = product(direction, forcesOf(world));
    length = there < slope ? std::clamp(slope / (slope - there), 0.1, 3.0) * trial : 2 * trial;
    moveAlong(world, places, direction, length);
    const Field now = forcesOf(world);
    const double kept = std::max(0.0, (product(now, now) - product(now, forces)) / squares);
    for (std::size_t i = 0; i < now.size(); ++i) direction[i] = now[i] + kept * direction[i];
    forces = now;
  }
  return false;
}

/// Returns a scene of four taut cells that fill an ellipsoid and first settle to `residual`.
Scene pressed(double residual) {
  Scene scene = scenes::settling(scenes::packed());
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "still.dna");
  scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
  scene.mechanics->physics.shell = ShellParameters{{1.2, 1, 0.88}, {}, Held::vertices};
  scene.mechanics->physics.pressure.constant = 260;
  scene.mechanics->physics.quasiStatic = {.evaluations = 1, .residual = residual};
  for (const Point& at : {Point{1, 0.8, 0.7}, Point{1, -0.8, -0.7}, Point{-1, 0.8, -0.7}, Point{-1, -0.8, 0.7}})
    scene.cells.push_back({.at = {0.45 * at.x, 0.45 * at.y, 0.45 * at.z}, .scale = 0.62});
  return scene;
}

}  // namespace

TEST_CASE("Cells that press on each other come to rest where conjugate gradients end, too") {
  // With adhesion the minimisers agree only from a start near rest.
  for (const auto& [adhesion, begin] : {std::pair(0.0, 0.2), {0.0, 0.1}, {0.2, 0.03}}) {
    Scene scene = pressed(begin);
    if (adhesion > 0) scene.mechanics->contact->adhesion.emplace().strength = adhesion;
    World settled = ranToEnd(scene), other = ranToEnd(scene);
    const Field start = placesOf(settled);
    REQUIRE(farthest(start, placesOf(other)) == 0);

    settled.bodies->parameters.quasiStatic = {.residual = 1e-11};
    settleEnd(settled);
    CAPTURE(adhesion, begin, settled.settlings->back().evaluations);
    CHECK(settled.settlings->back().residual <= 1e-11);
    CHECK(conjugateGradients(other, 1e-10));

    CHECK(measureEnergy(other).contact > 0.05);
    CHECK(farthest(placesOf(settled), start) > 0.02);
    CHECK(farthest(placesOf(settled), placesOf(other)) <= 1e-6 * 0.62);  // 0.62: a cell's radius
  }
}
