// Contact in Bullet: between cells, and with the shell, which Bullet itself lacks.
#include "catch.h"
#include "engines/bullet_world.h"
#include "lab.h"
#include "mesh_oracles.h"
#include "physics/shell_surface.h"
#include "worst.h"

using namespace morula;

namespace {

/// Returns two cells side by side in a shell that is too short for them.
BulletScene pressedPair(bool contact) {
  BulletScene scene = pressurisedCell(2, Baseline::b1, 8);
  scene.contact = contact;
  scene.physics.membrane.damping = 0.02;
  scene.physics.shell = ShellParameters{{1.9, 1.3, 1.3}};
  Body left = scene.cells[0], right = scene.cells[0];
  for (Point& x : left.position) x = 0.8 * x - Vector{0.9, 0, 0};
  for (Point& x : right.position) x = 0.8 * x + Vector{0.9, 0, 0};
  scene.cells = {left, right};
  return scene;
}

/// Returns how many vertices of a cell lie inside the other.
int countInside(const BulletScene& scene, const Body& cell, const Body& other) {
  int inside = 0;
  for (const Point& x : cell.position) inside += isInside(x, other.position, scene.mesh.faces);
  return inside;
}

std::vector<Body> run(const BulletScene& scene, int steps) {
  const auto world = makeBulletWorld(scene);
  for (int i = 0; i < steps; ++i) world->step();
  return world->cells();
}

}  // namespace

TEST_CASE("Cells stop each other, and the shell stops both") {
  NEEDS_BULLET
  BulletScene scene = pressedPair(true);
  const Held holds = GENERATE(Held::vertices, Held::surface);
  scene.physics.shell->holds = holds;
  const auto cells = run(scene, 800);
  CHECK(countInside(scene, cells[0], cells[1]) == 0);
  CHECK(countInside(scene, cells[1], cells[0]) == 0);
  // The cells touch: apart they would be longer than the shell.
  CHECK(measureBox(cells[0].position).high.x > measureBox(cells[1].position).low.x - 3 * scene.margin);
  Worst vertex, held;
  Bodies bodies = makeBodies(scene.physics, scene.mesh, 1);
  setBodies(bodies, scene.cells);
  for (const Body& cell : cells) {
    for (const Point& p : cell.position) vertex.see(std::abs(p.x) / 1.9);
    for (const Point& p : cell.position) held.see(std::abs(heldPoint(p, *scene.physics.shell, bodies.sag[0]).x) / 1.9);
  }
  CHECK(held <= 1 + 1e-12);
  CHECK(held > 0.999);
  CHECK((vertex > 1.001) == (holds == Held::surface));  // vertices stand above the surface that holds the volume
}

TEST_CASE("Without contact they run through each other") {
  NEEDS_BULLET
  const BulletScene scene = pressedPair(false);
  const auto cells = run(scene, 800);
  CHECK(countInside(scene, cells[0], cells[1]) > 10);
}
