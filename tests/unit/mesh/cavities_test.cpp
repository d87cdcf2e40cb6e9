// Voids of known volume: between the cells of a thick polyhedral shell, walls and balls.
#include "mesh/cavities.h"

#include <cmath>

#include "catch.h"
#include "zoo.h"

using namespace morula;

namespace {

Cavities cavitiesOf(const std::vector<Mesh>& cells, double probe) {
  std::vector<MeshView> views;
  for (const Mesh& m : cells) views.push_back({m.vertices, m.faces});
  return measureCavities(views, probe);
}

/// Returns a cell on each face of an icosphere, out to `out` times its corners and shrunk about its own middle.
std::vector<Mesh> shellOfCells(int level, double out, double shrunk = 0) {
  const Mesh inner = makeIcosphere(level);
  std::vector<Mesh> cells;
  for (const auto& [a, b, c] : inner.faces) {
    Mesh cell;
    for (const double r : {1., out})
      for (const int v : {a, b, c}) cell.vertices.push_back(r * inner.vertices[v]);
    cell.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    const Point middle = measureCentroid(cell.vertices);
    for (Point& x : cell.vertices) x = middle + (1 - shrunk) * (x - middle);
    cells.push_back(cell);
  }
  return cells;
}

std::vector<Mesh> moved(std::vector<Mesh> cells) {
  for (Mesh& cell : cells)
    for (Point& x : cell.vertices)
      x = Point{(2 * x.x - 2 * x.y + x.z) / 3 + 5, (2 * x.x + x.y - 2 * x.z) / 3 - 2,
                (x.x + 2 * x.y + 2 * x.z) / 3 + 0.37};  // a rotation: columns have length 1
  return cells;
}

Mesh ball(const Vector& at) { return zoo::moved(scaleToRadius(makeIcosphere(2), 1), at); }

/// Returns balls of radius 1, each touching twelve others.
std::vector<Mesh> closePacked() {
  std::vector<Mesh> balls;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k)
        if ((i + j + k) % 2 == 0) balls.push_back(ball(std::sqrt(2.) * Vector{double(i), double(j), double(k)}));
  return balls;
}

}  // namespace

TEST_CASE("The void of a closed shell of cells is its polyhedron, to the error that is stated, however it lies") {
  const Mesh inner = makeIcosphere(1);
  const double volume = measureVolume(inner.vertices, inner.faces), area = measureArea(inner.vertices, inner.faces);
  const std::vector<Mesh> cells = shellOfCells(1, 1.5);
  REQUIRE(cells.size() == 80);
  for (const auto& lying : {cells, moved(cells)}) {
    const Cavities found = cavitiesOf(lying, 0.15);
    CHECK(found.edge < 0.03);
    CHECK(std::abs(found.volume - volume) < std::sqrt(0.75) * found.edge * area);
    CHECK(found.volume == Approx(volume).epsilon(0.01));  // errors have both signs and cancel
    CHECK(found.largest == found.volume);
  }
  CHECK(cavitiesOf(shellOfCells(1, 1.5, 0.05), 0.15).volume == Approx(volume).epsilon(0.15));  // the probe closes gaps
}

TEST_CASE(
    "A shell with a hole that lets the probe through encloses nothing, and a probe that does not get out tells so") {
  std::vector<Mesh> cells = shellOfCells(0, 1.5);
  const double volume = cavitiesOf(cells, 0.2).volume;
  CHECK(volume > 2);
  cells.pop_back();  // leaves a triangle of edge 1.05, whose inscribed circle has a radius of 0.30
  CHECK(cavitiesOf(cells, 0.2).volume == 0);
  CHECK(cavitiesOf(cells, 0.45).volume > 1);
  CHECK(cavitiesOf(shellOfCells(0, 1.5), 0.9).volume ==
        0);  // the probe does not fit in: the void's inscribed ball has a radius of 0.79
}

TEST_CASE("A crowd that is packed encloses nothing: touching boxes, and balls each of which touches twelve others") {
  std::vector<Mesh> boxes;
  for (int i = 0; i < 27; ++i) {
    const Point low{double(i % 3), double(i / 3 % 3), double(i / 9)};
    boxes.push_back(zoo::box(low, low + Vector{1, 1, 1}));
  }
  CHECK(cavitiesOf(boxes, 0.3).volume == 0);
  boxes.erase(boxes.begin() + 13);  // removes the middle box
  const Cavities hollow = cavitiesOf(boxes, 0.05);
  CHECK(hollow.volume == Approx(1).epsilon(0.05));
  boxes.push_back(zoo::box({0, 0, 3}, {3, 3, 4}));
  boxes.push_back(zoo::box({0, 0, 5}, {3, 3, 6}));
  for (const auto& [low, high] : {std::pair<Point, Point>{{0, 0, 4}, {3, 1, 5}},
                                  {{0, 2, 4}, {3, 3, 5}},
                                  {{0, 1, 4}, {0.5, 2, 5}},
                                  {{2.5, 1, 4}, {3, 2, 5}}})
    boxes.push_back(zoo::box(low, high));  // boxes around another void, of 2 × 1 × 1
  const Cavities two = cavitiesOf(boxes, 0.1);
  CHECK(two.volume == Approx(3).epsilon(0.05));
  CHECK(two.largest == Approx(2).epsilon(0.05));
  // Six balls leave room for a ball of 0.414 radii, and three balls let 0.155 radii through.
  CHECK(cavitiesOf(closePacked(), 0.5).volume == 0);
  CHECK(cavitiesOf(closePacked(), 0.25).volume > 0.1);
}

TEST_CASE("Where probes come to rest is a probe's radius away from the nearest surface, to twice the cubes' edge") {
  const Cavities one = cavitiesOf({ball({4, 0, -1})}, 0.5);
  REQUIRE(one.edge == Approx(0.5 / 16));
  for (const Point& probe : one.outside)
    CHECK(std::abs(norm(probe - Point{4, 0, -1}) - 1.5) < 2 * one.edge + 0.03);  // 0.03: flatness of its mesh
  const Cavities shell = cavitiesOf(shellOfCells(1, 1.5), 0.15);
  for (const Point& probe : shell.outside) CHECK(norm(probe) > 1.5);       // no probe is in the void
  CHECK(cavitiesOf({ball({}), ball({900, 0, 0})}, 1e-3).outside.empty());  // the grid is too coarse
  CHECK(cavitiesOf({}, 1).volume == 0);
}
