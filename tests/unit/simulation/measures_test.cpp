// What is read off a world is what its meshes say.
#include <numbers>

#include "catch.h"
#include "mesh/overlap.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("Each cell's measures are those of its mesh") {
  World world = makeWorld(scenes::packed(), {bestIsa(), 1});
  while (world.clock.time < 3.5) step(world);
  const auto cells = measureCells(world);
  REQUIRE(cells.size() == 8);
  double total = 0, pressures = 0;
  Worst outermost;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const CellMeasures& m = cells[i];
    CHECK(m.path == world.cells.path[i]);
    CHECK(m.state == world.cells.state[i]);
    const auto x = cellVertices(world, m.path);
    const auto& faces = world.model.mechanics->mesh.faces;
    CHECK(m.volume == Approx(measureVolume(x, faces)).epsilon(1e-14));
    CHECK(m.volume == Approx(world.bodies->volume[i]).epsilon(1e-12));
    CHECK(m.area == measureArea(x, faces));
    CHECK(m.pressure == Approx(world.bodies->pressure[i]).epsilon(1e-9));
    CHECK(m.sphericity == sphericity(m.volume, m.area));
    CHECK(m.sphericity < 1);
    CHECK(m.centroid == measureCentroid(x));
    CHECK(m.neighbours >= 3);
    total += m.volume;
    pressures += m.pressure / 8;
    for (const Point& p : x) outermost.see(norm(p));
  }
  const WorldMeasures w = measureWorld(world);
  CHECK(w.time == world.clock.time);
  CHECK(w.step == world.clock.step);
  CHECK(w.cells == 8);
  CHECK(w.volume.value() == Approx(total).epsilon(1e-12));
  CHECK(w.meanPressure.value() == Approx(pressures).epsilon(1e-9));
  CHECK(w.shellFill.value() == Approx(total / (4 * std::numbers::pi / 3)).epsilon(1e-12));
  CHECK(w.shellFill.value() > 0.5);
  CHECK(w.outermost.value() == Approx(outermost).epsilon(1e-14));
  CHECK(w.outermost.value() <= 1 + 1e-12);
}

TEST_CASE("Contacts are by pairs of paths and agree with the neighbours counted") {
  World world = makeWorld(scenes::packed(), {bestIsa(), 1});
  while (world.clock.time < 3.5) step(world);
  std::vector<int> neighbours(8);
  const auto contacts = measureContacts(world);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    CHECK(contacts[i].a < contacts[i].b);
    CHECK(contacts[i].area > 0);
    if (i > 0)
      CHECK(std::pair(contacts[i - 1].a, contacts[i - 1].b) < std::pair(contacts[i].a, contacts[i].b));
    for (const CellPath& p : {contacts[i].a, contacts[i].b}) ++neighbours[slotOf(world, p.text().c_str())];
  }
  const auto cells = measureCells(world);
  for (int i = 0; i < 8; ++i) CHECK(cells[i].neighbours == neighbours[i]);
}

TEST_CASE(
    "Kinetic energy is that of the vertices; in an ellipsoid the outermost vertex is measured in its axes") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  scene.mechanics->physics.shell = ShellParameters{{2, 1.5, 1.25}};
  World world = makeWorld(scene);
  for (int v = 0; v < world.bodies->vertexCount(); ++v) world.bodies->velocity[world.bodies->at(0, v)] = 3;
  CHECK(measureWorld(world).kineticEnergy.value() == Approx(0.5 * 1 * 9).epsilon(1e-14));
  Worst outermost;
  for (const Point& p : cellVertices(world, CellPath{}))
    outermost.see(std::sqrt(p.x * p.x / 4 + p.y * p.y / 2.25 + p.z * p.z / 1.5625));
  CHECK(measureWorld(world).outermost.value() == Approx(outermost).epsilon(1e-14));
}

TEST_CASE("Energy, volume and pressure are of all cells") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  Body left = shakenBody(scene.mechanics->mesh, 0, 0), right = left;
  left.pressureConstant = 200;
  right.pressureConstant = 100;
  right.mass = 3;
  for (Vector& u : left.velocity) u = {2, 0, 0};
  for (Vector& u : right.velocity) u = {0, 0, 4};
  for (Point& x : right.position) x.y += 5;
  const World world = worldOf(scene, {left, right});
  const WorldMeasures m = measureWorld(world);
  const double volume = measureVolume(left.position, scene.mechanics->mesh.faces);
  CHECK(m.kineticEnergy.value() == Approx(0.5 * 1 * 4 + 0.5 * 3 * 16).epsilon(1e-13));
  CHECK(m.volume.value() == Approx(2 * volume).epsilon(1e-13));
  CHECK(m.meanPressure.value() == Approx(150 / volume - 200 / volume).epsilon(1e-12));
}

TEST_CASE("The mean overlap of two balls is the lens they share") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(3));
  Body left = shakenBody(makeIcosphere(3), 0, 0), right = left;
  left.pressureConstant = right.pressureConstant = 200;
  for (double distance : {0.5, 1.5, 2.5}) {
    Body moved = right;
    for (Point& x : moved.position) x.y += distance;
    const World world = worldOf(scene, {left, moved});
    const double lens =
        distance < 2 ? std::numbers::pi * (4 + distance) * (2 - distance) * (2 - distance) / 12 : 0;
    CHECK(measureMeanOverlap(world) == Approx(lens / (4 * std::numbers::pi / 3)).margin(0.01));
  }
}

TEST_CASE("A path that does not live has no vertices") {
  const World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 1));
  CHECK(cellVertices(world, CellPath{}) == world.model.mechanics->mesh.vertices);
  CHECK(cellVertices(world, CellPath::parse("A")).empty());
}
