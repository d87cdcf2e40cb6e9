// Cells with different meshes in one world.
#include <algorithm>

#include "catch.h"
#include "contacts/neighbour_list.h"
#include "worlds.h"

using namespace morula;

namespace {

std::int32_t numberOf(const Bodies& b, int slot, int v) {
  return (b.blocks[slot / blockLanes].firstLine + v) * blockLanes + slot % blockLanes;
}

}  // namespace

TEST_CASE("Cells stand by mesh in whole blocks, and are found again by number") {
  const Scene scene = scenes::mixedMeshes();
  const std::vector<Body> cells = mixedCells(scene, 19, 2.5, 0);
  const World world = worldOf(scene, cells);
  const Bodies& b = *world.bodies;
  REQUIRE(b.blockCount() == 4);  // ten cells with one mesh, nine with the other
  CHECK(b.blocks[1].firstLine == 162);
  CHECK(b.blocks[3].firstLine == 2 * 162 + 42);
  CHECK(b.lineCount() == 2 * 162 + 2 * 42);
  CHECK(b.livingVertices == 10 * 162 + 9 * 42);
  CHECK(b.slots[0] == 0);
  CHECK(b.slots[1] == 16);
  CHECK(b.slots[18] == 9);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Body body = takeBody(b, b.slots[i]);
    CHECK(body.meshLevel == cells[i].meshLevel);
    CHECK(body.position == cells[i].position);
    CHECK(body.velocity == cells[i].velocity);
    CHECK(body.mass == Approx(cells[i].mass).epsilon(1e-14));
    CHECK(cellMesh(world, world.cells.path[i]).vertices == cells[i].position);
    // A vertex's reach depends on its own mesh: 42 vertices are twice as far apart as 162.
    CHECK(world.contacts->radius[b.slots[i]] / world.contacts->radius[0] ==
          Approx(cells[i].meshLevel == 0 ? 1 : 2).epsilon(0.02));
  }
}

TEST_CASE("A cell that touches nobody moves as in a world of its own kind, to the last bit") {
  Scene scene = scenes::mixedMeshes();
  const std::vector<Body> cells = mixedCells(scene, 11, 50, 0.3);
  for (Isa isa : availableIsas()) {
    scene.mechanics->physics.timeStep = 0x1p-10;
    World mixed = worldOf(scene, cells, {isa, 1});
    std::vector<World> alone;
    for (int meshLevel : {0, 1}) {
      Scene own = scene;
      // The coarser mesh as large as in the mixed world: with the finer mesh's volume.
      own.mechanics->mesh = mixed.bodies->meshAt(meshLevel).mesh;
      own.mechanics->coarser.clear();
      std::vector<Body> some;
      for (Body cell : cells)
        if (std::exchange(cell.meshLevel, 0) == meshLevel) some.push_back(cell);
      alone.push_back(worldOf(own, some, {isa, 1}));
    }
    for (int i = 0; i < 100; ++i) step(mixed), step(alone[0]), step(alone[1]);
    int different = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Body a = takeBody(*mixed.bodies, mixed.bodies->slots[i]),
                 b = takeBody(*alone[i % 2].bodies, static_cast<int>(i / 2));
      different += a.position != b.position || a.velocity != b.velocity;
    }
    CAPTURE(name(isa));
    CHECK(different == 0);
  }
}

TEST_CASE("Every search finds the neighbours between meshes: all within the mean of the two radii") {
  const Scene scene = scenes::mixedMeshes();
  for (ContactSearch search : valuesOf<ContactSearch>()) {
    World world = worldOf(scene, mixedCells(scene, 13, 1.9, 0.5), {bestIsa(), 1, {search, 0.15}});
    for (int i = 0; i < 40; ++i) step(world);
    world.contacts->listIsValid = false;
    step(world);
    const Bodies& b = *world.bodies;
    const Contacts& c = *world.contacts;
    std::size_t between = 0;
    int wrong = 0;
    for (int i : b.slots)
      for (int v = 0; v < b.vertexCount(i); ++v) {
        std::vector<VertexNumber> expected;
        for (int j : b.slots)
          for (int w = 0; w < b.vertexCount(j) && i != j; ++w) {
            const Vector d = b.read(c.list.reference, i, v) - b.read(c.list.reference, j, w);
            const double reach = 0.5 * (c.radius[i] + c.radius[j]) * (1 + 1e-6) + c.list.skin;
            if (dot(d, d) >= reach * reach) continue;
            expected.push_back(numberOf(b, j, w));
            between += b.vertexCount(i) != b.vertexCount(j);
          }
        std::sort(expected.begin(), expected.end());
        wrong += neighboursOf(c.list, numberOf(b, i, v)) != expected;
      }
    CAPTURE(nameOf(search));
    CHECK(between > 100);
    CHECK(wrong == 0);
  }
}

TEST_CASE("Colliding cells with different meshes keep their momentum") {
  Scene scene = scenes::mixedMeshes();
  scene.mechanics->physics.drag = 0;
  World world = worldOf(scene, mixedCells(scene, 8, 2.3, 1));
  const Vector before = momentumOf(*world.bodies);
  double size = 0;
  for (const Body& cell : mixedCells(scene, 8, 2.3, 1)) size += cell.mass * norm(measureCentroid(cell.velocity));
  Worst drift;
  bool touched = false;
  while (world.clock.time < 1) {
    step(world);
    drift.see(norm(momentumOf(*world.bodies) - before) / size);
    touched = touched || world.contacts->list.pairs > 0;
  }
  CHECK(touched);
  CHECK(drift <= 1e-12);
}

TEST_CASE("Contact areas name cells by number, and both meshes see the same cells") {
  const Scene scene = scenes::mixedMeshes();
  World world = worldOf(scene, mixedCells(scene, 8, 1.72, 0));
  for (int i = 0; i < 10; ++i) step(world);
  const std::vector<ContactMeasures> areas = measureContacts(world);
  CHECK(areas.size() == 12);  // the edges of a cube
  for (const ContactMeasures& touch : areas) {
    CHECK(touch.at("area") > 0);
    const double distance =
        norm(measureCentroid(cellVertices(world, touch.a)) - measureCentroid(cellVertices(world, touch.b)));
    CHECK(distance < 2.3);
  }
}

TEST_CASE("Small daughters take the coarser mesh; volumes, mass and momentum go on, and steps get longer") {
  Scene scene = scenes::coarsening();
  scene.mechanics->physics.shell.reset();
  scene.mechanics->physics.drag = 0;
  World world = makeWorld(scene);
  Bodies& b = *world.bodies;
  for (int v = 0; v < b.vertexCount(0); ++v) b.velocity[b.at(0, v)] = 0.3 + 0.1 * noise(static_cast<std::uint32_t>(v));
  const Vector before = momentumOf(b);
  Worst drift, mass;
  while (!finished(world)) {
    step(world);
    drift.see(norm(momentumOf(b) - before) / norm(before));
    double sum = 0;
    for (int slot : b.slots) sum += b.mass(slot);
    mass.see(std::abs(sum - 1));
  }
  REQUIRE(world.cells.path.size() == 5);
  CHECK(cellVertices(world, CellPath::parse("A")).size() == 642);
  for (const char* path : {"BAA", "BAB", "BBA", "BBB"}) CHECK(cellVertices(world, CellPath::parse(path)).size() == 162);
  CHECK(drift <= 1e-12);
  CHECK(mass <= 1e-14);
  scene.mechanics->physics.coarsen.reset();
  scene.mechanics->coarser.clear();
  CHECK(world.clock.timeStep == 2 * ranToEnd(scene).clock.timeStep);
}

TEST_CASE("A length that no daughter falls below changes no bit") {
  Scene scene = scenes::coarsening(), without = scene;
  scene.mechanics->physics.coarsen = 0.01;
  without.mechanics->physics.coarsen.reset();
  without.mechanics->coarser.clear();
  CHECK(stateHash(ranToEnd(scene)) == stateHash(ranToEnd(without)));
}

TEST_CASE("Who searches, and on how many threads, changes no bit between meshes") {
  const Scene scene = scenes::coarsening();
  const Hash expected = stateHash(ranToEnd(scene));
  for (ContactSearch search : valuesOf<ContactSearch>())
    for (int threads : {1, 3}) {
      if (search == ContactSearch::bruteForce) continue;  // slow; a test above compares the lists with it
      CAPTURE(nameOf(search), threads);
      CHECK(stateHash(ranToEnd(scene, {bestIsa(), threads, {search, 0.1}})) == expected);
    }
}
