// Connections as springs, and the max number of connections of a cell.
#include "catch.h"
#include "connections/connections.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

const std::vector<CellPath> pathsOfCells{CellPath::parse("AA"), CellPath::parse("AB")};

struct Spring {
  std::array<Vector, 2> forces;  // on the two cells
  double energy;
};

/// Returns a spring between two round cells, the second one of `size`; each now has the volume `volume`.
Spring stretched(const ConnectionSpring& spring, const Vector& between, double size, double volume = 1) {
  const Mesh ball = makeIcosphere(2);
  Body one = shakenBody(ball, 0, 0), other = one;
  for (Point& x : other.position) x = size * x + between;
  other.restScale = size;
  PhysicsParameters p = softCell();
  p.cell.radius = 1;
  Lab lab(p, ball, {one, other});
  lab.bodies.volume.assign(lab.bodies.volume.size(), volume);
  lab.bodies.acceleration.assign(lab.bodies.acceleration.size(), 0);
  Connections c;
  c.parameters.spring = spring;
  connect(c, pathsOfCells[0], pathsOfCells[1], 0);
  addConnectionForces(c, pathsOfCells, lab.bodies);
  return {{lab.forceOn(0), lab.forceOn(1)}, measureConnectionEnergy(c, pathsOfCells, lab.bodies)};
}

}  // namespace

TEST_CASE("A spring pulls cells that are farther apart than at rest, and pushes nearer ones") {
  const Vector way = Vector{2, -1, 2} / 3.0;
  // Radii 1 and 0.5 with rest 1.2 give the rest length 1.8; the stiffness is 3.
  for (const auto& [distance, force] : {std::pair{1.8, 0.0}, {2.8, 3.0}, {1.3, -1.5}}) {
    const auto [a, b] = stretched({3, 1.2}, distance * way, 0.5).forces;
    CAPTURE(distance);
    CHECK(norm(a - force * way) < 1e-12);
    CHECK(norm(a + b) < 1e-12);
  }
}

TEST_CASE("Turning two cells turns the spring's force") {
  const Vector along = stretched({2, 0.5}, {3, 0, 0}, 1).forces[0],
               across = stretched({2, 0.5}, {0, 0, -3}, 1).forces[0];
  CHECK(along.x == Approx(4));
  CHECK(across.z == Approx(-along.x));
  CHECK(norm(along) == Approx(norm(across)));
}

TEST_CASE(
    "A spring's length at rest goes by the radii at rest, whatever the volumes are, and its force is its "
    "energy's slope") {
  for (double volume : {0.1, 1.0, 5.0}) CHECK(stretched({3, 1.2}, {2.8, 0, 0}, 0.5, volume).forces[0].x == Approx(3));
  for (double distance : {1.3, 1.8, 2.8}) {
    const auto energyAt = [](double d) { return stretched({3, 1.2}, {d, 0, 0}, 0.5).energy; };
    const double slope = (energyAt(distance + 1e-5) - energyAt(distance - 1e-5)) / 2e-5;
    CHECK(stretched({3, 1.2}, {distance, 0, 0}, 0.5).forces[0].x == Approx(slope).margin(1e-8));
    CHECK(energyAt(distance) == Approx(1.5 * (distance - 1.8) * (distance - 1.8)).margin(1e-12));
  }
}

TEST_CASE("No cell gets more connections than it may have, and room is made by a release") {
  Connections c;
  c.parameters.most = 2;
  const auto cell = [](const char* path) { return CellPath::parse(path); };
  for (const char* other : {"BA", "BB", "A"}) connect(c, cell("AA"), cell(other), 0);
  CHECK(partners(c, cell("AA")) == std::vector<CellPath>{cell("BA"), cell("BB")});
  connect(c, cell("BB"), cell("A"), 0);  // both have room
  CHECK(areConnected(c, cell("A"), cell("BB")));
  connect(c, cell("BA"), cell("BB"), 0);  // BB has no room
  CHECK_FALSE(areConnected(c, cell("BA"), cell("BB")));
  connect(c, cell("AA"), cell("BB"), 0);  // the connection holds already
  CHECK(c.history.size() == 3);
  release(c, cell("AA"), cell("BA"), 1, ReleaseCause::age);
  connect(c, cell("AA"), cell("A"), 2);
  CHECK(areConnected(c, cell("AA"), cell("A")));
}
