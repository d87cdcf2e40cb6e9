#include <numbers>

#include "catch.h"
#include "mesh/mesh_measures.h"
#include "mesh_oracles.h"
#include "zoo.h"

using namespace morula;

namespace {

using std::numbers::pi;

// Returns the volume in another way: each face's shadow on the ground times its mean height, in long double.
long double volumeByPrisms(const Mesh& m) {
  long double sum = 0;
  for (const auto& [i, j, k] : m.faces) {
    const Point &a = m.vertices[i], &b = m.vertices[j], &c = m.vertices[k];
    const long double shadow = (static_cast<long double>(b.x) - a.x) * (static_cast<long double>(c.y) - a.y) -
                               (static_cast<long double>(b.y) - a.y) * (static_cast<long double>(c.x) - a.x);
    sum += shadow / 2 * (static_cast<long double>(a.z) + b.z + c.z) / 3;
  }
  return sum;
}

double areaOf(const Mesh& m) { return measureArea(m.vertices, m.faces); }

}  // namespace

TEST_CASE("Volume and area of bodies with closed forms") {
  CHECK(zoo::volumeOf(zoo::tetrahedron()) == Approx(8.0 / 3).epsilon(1e-15));
  CHECK(areaOf(zoo::tetrahedron()) == Approx(8 * std::sqrt(3.0)).epsilon(1e-15));
  const Mesh box = zoo::box({1, 2, 3}, {2, 4, 7});  // 1 × 2 × 4
  CHECK(zoo::volumeOf(box) == 8);
  CHECK(areaOf(box) == 28);
  CHECK(zoo::volumeOf(zoo::inverted(box)) == -8);
  CHECK(zoo::volumeOf({}) == 0);
  CHECK(areaOf({}) == 0);
}

TEST_CASE("The divergence theorem and the sum of prisms agree on every closed mesh") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    CHECK(zoo::volumeOf(mesh) == Approx(static_cast<double>(volumeByPrisms(mesh))).epsilon(1e-13));
  }
}

TEST_CASE("Where a cell lies does not change its volume") {
  const Mesh egg = zoo::crumpled(makeIcosphere(2), 0.2, 3);
  const double here = zoo::volumeOf(egg);
  // At 1e6 radii positions have lost six digits, and so has the volume, but not more.
  CHECK(std::abs(zoo::volumeOf(zoo::moved(egg, {1e6, -1e6, 1e6})) / here - 1) < 1e-10);
}

TEST_CASE("Icospheres converge to the sphere with the square of the edge length") {
  double volumeBefore = 0, areaBefore = 0;
  for (int level = 0; level <= 4; ++level) {
    const Mesh m = makeIcosphere(level);
    const double volumeError = 4 * pi / 3 - zoo::volumeOf(m), areaError = 4 * pi - areaOf(m);
    if (level > 2) {  // lower levels still show the icosahedron's angles
      CHECK(volumeBefore / volumeError == Approx(4).epsilon(0.03));
      CHECK(areaBefore / areaError == Approx(4).epsilon(0.03));
    }
    volumeBefore = volumeError, areaBefore = areaError;
  }
  CHECK(volumeBefore / (4 * pi / 3) < 0.003);
}

TEST_CASE("An ellipsoid has the sphere's volume times its three axes") {
  for (int level = 0; level <= 4; ++level) {
    const Mesh m = makeIcosphere(level);
    CHECK(zoo::volumeOf(zoo::scaled(m, {27, 15, 11})) == Approx(27 * 15 * 11 * zoo::volumeOf(m)).epsilon(1e-13));
  }
}

TEST_CASE("Centroid and box are those of the vertices") {
  const Mesh m = zoo::moved(zoo::scaled(makeIcosphere(2), {3, 2, 1}), {10, 20, 30});
  CHECK(norm(measureCentroid(m.vertices) - Point{10, 20, 30}) < 1e-14 * 40);
  const Mesh box = zoo::box({1, 2, 3}, {2, 4, 7});
  CHECK(measureCentroid(box.vertices) == Point{1.5, 3, 5});
  CHECK(measureBox(box.vertices).low == Point{1, 2, 3});
  CHECK(measureBox(box.vertices).high == Point{2, 4, 7});
  CHECK_THROWS_AS(measureCentroid({}), BugError);
  CHECK_THROWS_AS(measureBox({}), BugError);
}

TEST_CASE("Sphericity compares with the sphere of the same volume") {
  CHECK(sphericity(4 * pi / 3, 4 * pi) == Approx(1).epsilon(1e-15));
  CHECK(sphericity(1, 6) == Approx(std::cbrt(pi / 6)).epsilon(1e-15));  // a cube
  CHECK(sphericity(1e-60, 6e-40) == Approx(std::cbrt(pi / 6)).epsilon(1e-15));
  CHECK(sphericity(0, 1) == 0);
  CHECK(sphericity(-1, 1) == 0);
  CHECK(sphericity(1, 0) == 0);
  // No closed body is rounder than a sphere.
  for (const auto& [name, mesh, handles] : zoo::all()) {
    CAPTURE(name);
    CHECK(sphericity(zoo::volumeOf(mesh), areaOf(mesh)) < 1);
    CHECK(sphericity(zoo::volumeOf(mesh), areaOf(mesh)) > 0.3);
  }
}

TEST_CASE("Faces turned inward are counted") {
  Mesh m = makeIcosphere(2);
  CHECK(countFacesTurnedInward(m.vertices, m.faces, {0, 0, 0}) == 0);
  CHECK(countFacesTurnedInward(m.vertices, m.faces, {2, 0, 0}) > 0);
  for (int f : {3, 77, 200}) std::swap(m.faces[f][0], m.faces[f][1]);
  CHECK(countFacesTurnedInward(m.vertices, m.faces, {0, 0, 0}) == 3);
  // A face counts for points in front of it and in its plane.
  const Mesh cube = zoo::box({-1, -1, -1}, {1, 1, 1});
  CHECK(countFacesTurnedInward(cube.vertices, cube.faces, {0.99, 0, 0}) == 0);
  CHECK(countFacesTurnedInward(cube.vertices, cube.faces, {1, 0, 0}) == 2);
  CHECK(countFacesTurnedInward(cube.vertices, cube.faces, {2, 0, 0}) == 2);
  CHECK(countFacesTurnedInward(cube.vertices, cube.faces, {2, -2, 0}) == 4);
  CHECK(countFacesTurnedInward(cube.vertices, cube.faces, {2, -2, 2}) == 6);
}

TEST_CASE("A mesh scaled to a radius holds that sphere's volume, and keeps its shape") {
  for (const auto& animal : zoo::all())
    for (const double radius : {1e-6, 0.95, 1.0, 1e6}) {
      CAPTURE(animal.name, radius);
      const Mesh scaled = scaleToRadius(animal.mesh, radius);
      CHECK(zoo::volumeOf(scaled) == Approx(4 * pi / 3 * radius * radius * radius).epsilon(1e-13));
      CHECK(scaled.faces == animal.mesh.faces);
      const double factor = norm(scaled.vertices[0]) / norm(animal.mesh.vertices[0]);
      for (std::size_t v = 0; v < scaled.vertices.size(); ++v)
        CHECK(norm(scaled.vertices[v] - factor * animal.mesh.vertices[v]) <=
              1e-13 * factor * norm(animal.mesh.vertices[v]));
    }
}
