// Plane sections of closed meshes, against areas worked out by hand.
#include "division/planes/section.h"

#include <numbers>

#include "base/random.h"
#include "catch.h"
#include "mesh/mesh_measures.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns a box from 0 to the corner (a, b, c).
Mesh box(double a, double b, double c) { return zoo::box({}, {a, b, c}); }

Mesh moved(Mesh mesh, const Turn& turn, const Vector& shift) {
  for (Point& x : mesh.vertices) x = turn(x) + shift;
  return mesh;
}

/// Returns the sine of the angle between two lines. [1]
double between(const Vector& a, const Vector& b) { return norm(cross(a, b)); }

}  // namespace

TEST_CASE("section: of a box along its sides, across its diagonal and through its corners' hexagon") {
  const Mesh brick = box(1, 2, 3);
  CHECK(measureVolume(brick.vertices, brick.faces) == Approx(6));
  const Point middle{0.5, 1, 1.5};
  CHECK(sectionArea(brick, middle, {1, 0, 0}) == Approx(6).epsilon(1e-14));
  CHECK(sectionArea(brick, middle, {0, 1, 0}) == Approx(3).epsilon(1e-14));
  CHECK(sectionArea(brick, middle, {0, 0, -1}) == Approx(2).epsilon(1e-14));
  CHECK(sectionArea(brick, {0.1, 1.9, 2.9}, {0, 0, 1}) == Approx(2).epsilon(1e-14));
  // A plane through two opposite edges of length 3 gives √(1² + 2²) · 3.
  CHECK(sectionArea(brick, middle, Vector{2, -1, 0} / std::sqrt(5.0)) == Approx(3 * std::sqrt(5.0)).epsilon(1e-12));
  // The regular hexagon of a unit cube has sides √½ and area 3√3/2 · ½.
  CHECK(sectionArea(box(1, 1, 1), {0.5, 0.5, 0.5}, Vector{1, 1, 1} / std::sqrt(3.0)) ==
        Approx(0.75 * std::sqrt(3.0)).epsilon(1e-14));
  CHECK(sectionArea(brick, {5, 0, 0}, {1, 0, 0}) == 0);
}

TEST_CASE("section: of an ellipsoid it is an ellipse; a cave is no part of it") {
  const Mesh mesh = zoo::scaled(makeIcosphere(4), {3, 2, 1});
  CHECK(sectionArea(mesh, {}, {1, 0, 0}) == Approx(2 * std::numbers::pi).epsilon(0.005));
  CHECK(sectionArea(mesh, {}, {0, 0, 1}) == Approx(6 * std::numbers::pi).epsilon(0.005));
  Mesh hollow = box(3, 3, 3), cave = box(1, 1, 1);
  for (const Face& f : cave.faces) hollow.faces.push_back({f[0] + 8, f[2] + 8, f[1] + 8});
  for (const Point& x : cave.vertices) hollow.vertices.push_back(x + Vector{1, 1, 1});
  CHECK(sectionArea(hollow, {1.5, 1.5, 1.5}, {0, 1, 0}) == Approx(8).epsilon(1e-14));
}

TEST_CASE("section: the smallest stands across the longest side, wherever that points") {
  const Mesh brick = box(1, 2, 3);
  CHECK(between(smallestSection(brick, {0.5, 1, 1.5}), {0, 0, 1}) < 1e-4);
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Turn turn(seed);
    const Vector shift{1, -2, 3};
    const Vector found = smallestSection(moved(zoo::scaled(makeIcosphere(4), {1.5, 1, 0.9}), turn, shift), shift);
    CHECK(between(found, turn({1, 0, 0})) < 0.02);  // exact for an ellipsoid; this body is of triangles
    CHECK(norm(found) == Approx(1).epsilon(1e-14));
    CHECK(dot(found, {1, 0.55, 0.2}) > 0);
  }
}

// The oracle tries many random directions, without refinement.
TEST_CASE("section: no other direction has a smaller one") {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const Body lump = shakenBody(makeIcosphere(2), 0.25, 0, seed);
    const Mesh mesh{lump.position, makeIcosphere(2).faces};
    const Point centre = measureCentroid(mesh.vertices);
    const double found = sectionArea(mesh, centre, smallestSection(mesh, centre));
    double least = found;
    for (std::uint32_t i = 0; i < 3000; ++i)
      least = std::min(least, sectionArea(mesh, centre, randomDirection({i, {}, 2, Purpose::test})));
    CHECK(found <= least * (1 + 1e-9));
  }
}

TEST_CASE("section: a lump that is turned or mirrored has its smallest section turned or mirrored") {
  const Body lump = shakenBody(makeIcosphere(2), 0.15, 0, 3);
  const Mesh mesh{lump.position, makeIcosphere(2).faces};
  const Vector before = smallestSection(mesh, measureCentroid(mesh.vertices));
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Turn turn(seed);
    const Mesh turned = moved(mesh, turn, {3, 0, -1});
    CHECK(between(smallestSection(turned, measureCentroid(turned.vertices)), turn(before)) < 1e-3);
  }
  Mesh mirrored = mesh;
  for (Point& x : mirrored.vertices) x.y = -x.y;
  for (Face& f : mirrored.faces) std::swap(f[1], f[2]);
  CHECK(between(smallestSection(mirrored, measureCentroid(mirrored.vertices)), {before.x, -before.y, before.z}) < 1e-3);
}

TEST_CASE("section: of equally small ones a rule decides, and not rounding") {
  const Vector found = smallestSection(box(1, 1, 1), {0.5, 0.5, 0.5});
  CHECK(between(found, {1, 0, 0}) < 1e-4);
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Mesh cube = box(1, 1, 1);
    for (std::uint32_t v = 0; v < 8; ++v) cube.vertices[v] += 1e-14 * noiseVector(v, seed);
    CHECK(norm(smallestSection(cube, {0.5, 0.5, 0.5}) - found) < 1e-4);
  }
}
