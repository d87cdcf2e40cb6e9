// Bodies go into the blocks and come out as they were, whatever the number of cells.
#include "catch.h"
#include "lab.h"

using namespace morula;

TEST_CASE("What is set is taken, for full and for started blocks") {
  const Mesh mesh = makeIcosphere(1);
  for (int count : {1, 2, 7, 8, 9, 17}) {
    std::vector<Body> cells;
    for (int i = 0; i < count; ++i) {
      cells.push_back(shakenBody(mesh, 0.1, 1, i));
      cells.back().mass = 42 * (1 + i);  // 42 vertices: the share of each is exact
      cells.back().restScale = 1 + 0.1 * i;
      cells.back().pressureConstant = 4 - 0.1 * i;
    }
    Lab lab(softCell(), mesh, cells);
    CHECK(lab.bodies.count == count);
    CHECK(lab.bodies.blockCount() == (count + 7) / 8);
    for (int i = 0; i < count; ++i) {
      const Body out = takeBody(lab.bodies, i);
      CHECK(out.position == cells[i].position);
      CHECK(out.velocity == cells[i].velocity);
      CHECK(out.mass == cells[i].mass);
      CHECK(out.restScale == cells[i].restScale);
      CHECK(out.pressureConstant == cells[i].pressureConstant);
      CHECK(lab.bodies.vertex(i, 5) == cells[i].position[5]);
    }
  }
}

TEST_CASE("The egg is the mesh as loaded, at rest") {
  PhysicsParameters p = softCell();
  p.cell.mass = 3;
  p.pressure.constant = 7;
  const Mesh mesh = zoo::torus(5, 4);
  const Bodies b = makeBodies(p, mesh, 1);
  const Body egg = makeEgg(b);
  CHECK(egg.position == mesh.vertices);
  CHECK(egg.velocity == std::vector<Vector>(20));
  CHECK(egg.mass == 3);
  CHECK(egg.restScale == 1);
  CHECK(egg.pressureConstant == 7);
}

TEST_CASE("A body with another number of vertices is a bug") {
  Lab lab(softCell(), makeIcosphere(1));
  CHECK_THROWS_AS(setBodies(lab.bodies, {shakenBody(makeIcosphere(0), 0, 0)}), BugError);
}

TEST_CASE("Lanes without a cell stay where they are") {
  const Mesh mesh = makeIcosphere(1);
  for (Isa isa : availableIsas()) {
    const std::vector<Body> three{shakenBody(mesh, 0.1, 1), shakenBody(mesh, 0.1, 1, 1), shakenBody(mesh, 0.1, 1, 2)};
    const Lab lab = stepped({softCell(), mesh, three, isa}, 100, 0x1p-9);
    Worst farthest;
    for (int lane = 3; lane < blockLanes; ++lane)
      for (int v = 0; v < lab.bodies.vertexCount(); ++v)
        farthest.see(norm(lab.bodies.vertex(lane, v) - mesh.vertices[v]));
    CHECK(farthest < 1e-100);
  }
}
