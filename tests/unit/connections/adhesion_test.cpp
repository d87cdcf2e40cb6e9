// Adhesion: a force of constant size between the centres of two connected cells [Nilsson 2008, eq. 4.9].
#include "catch.h"
#include "connections/connections.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

const std::vector<CellPath> paths{CellPath::parse("AA"), CellPath::parse("AB"), CellPath::parse("B")};

/// Three limp, moving cells with the forces of the given connections.
struct Scene {
  Lab lab;
  Connections connections;

  explicit Scene(const std::vector<Vector>& places) : lab(softCell(), makeIcosphere(1), cellsAt(places)) {
    connections.parameters.strength = 0.2;
    lab.bodies.acceleration.assign(lab.bodies.acceleration.size(), 0);
  }
  static std::vector<Body> cellsAt(const std::vector<Vector>& places) {
    std::vector<Body> cells;
    for (const Vector& p : places) cells.push_back(shakenBody(zoo::moved(makeIcosphere(1), p), 0.05, 1));
    return cells;
  }
};

}  // namespace

TEST_CASE("Each of two connected cells is drawn to the other with k_c, however far they are") {
  for (double distance : {0.5, 2.0, 50.0}) {
    const Vector way = Vector{1, 2, -2} / 3.0;
    Scene s({{}, distance * way, {9, 9, 9}});
    connect(s.connections, paths[0], paths[1], 0);
    addConnectionForces(s.connections, paths, s.lab.bodies);
    CHECK(norm(s.lab.forceOn(0) - 0.2 * way) < 1e-13);
    CHECK(norm(s.lab.forceOn(1) + 0.2 * way) < 1e-13);
    CHECK(norm(s.lab.forceOn(2)) == 0);
    CHECK(measureConnectionEnergy(s.connections, paths, s.lab.bodies) == Approx(0.2 * distance));
    // The force is spread evenly: it moves the cell without deforming it.
    for (int v = 0; v < s.lab.bodies.vertexCount(); ++v) CHECK(s.lab.force(0, v) == s.lab.force(0, 0));
    // Forces are equal and opposite to the last bit.
    CHECK(s.lab.force(1, 0) == -s.lab.force(0, 0));
  }
}

TEST_CASE("A cell with two connections feels both") {
  Scene s({{}, {2, 0, 0}, {0, 3, 0}});
  connect(s.connections, paths[0], paths[1], 0);
  connect(s.connections, paths[2], paths[0], 0);
  addConnectionForces(s.connections, paths, s.lab.bodies);
  CHECK(norm(s.lab.forceOn(0) - Vector{0.2, 0.2, 0}) < 1e-13);
  CHECK(norm(s.lab.forceOn(0) + s.lab.forceOn(1) + s.lab.forceOn(2)) < 1e-15);
}

TEST_CASE("What is released pulls no more; forces add to those that are there") {
  Scene s({{}, {2, 0, 0}, {0, 3, 0}});
  connect(s.connections, paths[0], paths[1], 0);
  connect(s.connections, paths[0], paths[2], 0);
  release(s.connections, paths[0], paths[1], 1, ReleaseCause::gene);
  addConnectionForces(s.connections, paths, s.lab.bodies);
  addConnectionForces(s.connections, paths, s.lab.bodies);
  CHECK(norm(s.lab.forceOn(0) - Vector{0, 0.4, 0}) < 1e-13);
  CHECK(norm(s.lab.forceOn(1)) == 0);
}

TEST_CASE("Two cells with one centre have no direction and feel no force") {
  Scene s({{}, {}, {}});
  connect(s.connections, paths[0], paths[1], 0);
  addConnectionForces(s.connections, paths, s.lab.bodies);
  CHECK(norm(s.lab.forceOn(0)) == 0);
  CHECK(norm(s.lab.forceOn(1)) == 0);
}
