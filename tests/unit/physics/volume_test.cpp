// The volume that the ring pass gathers is that of the mesh.
#include <numbers>

#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

double volumeOf(const Mesh& mesh) { return evaluated({softCell(), mesh}).bodies.volume[0]; }

}  // namespace

TEST_CASE("The rings give the volume that the faces give, for every mesh") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    INFO(name);
    CHECK(volumeOf(mesh) == Approx(zoo::volumeOf(mesh)).epsilon(1e-13));
  }
}

TEST_CASE("The rings give closed forms of volumes") {
  CHECK(volumeOf(zoo::box({1, 2, 3}, {2, 4, 7})) == Approx(8).epsilon(1e-14));
  CHECK(volumeOf(zoo::tetrahedron()) == Approx(8.0 / 3).epsilon(1e-14));
  CHECK(volumeOf(zoo::inverted(zoo::tetrahedron())) == Approx(-8.0 / 3).epsilon(1e-14));
  // The icosahedron in the unit sphere has the volume 2/3 √(10 + 2√5).
  CHECK(volumeOf(makeIcosphere(0)) == Approx(2.0 / 3 * std::sqrt(10 + 2 * std::sqrt(5.0))).epsilon(1e-14));
  // Volumes approach the sphere's with the square of the edge: four times closer at each level.
  const double ball = 4 * std::numbers::pi / 3;
  double missing = ball - volumeOf(makeIcosphere(2));
  for (int level = 3; level <= 4; ++level) {
    const double next = ball - volumeOf(makeIcosphere(level));
    CHECK(missing / next == Approx(4).margin(0.1));
    missing = next;
  }
}

TEST_CASE("Where a cell lies and how it moves does not change its volume") {
  const Mesh mesh = zoo::crumpled(makeIcosphere(2), 0.2, 3);
  const Lab here = evaluated({softCell(), mesh, {shakenBody(mesh, 0, 0)}}),
            there = evaluated({softCell(), mesh, {shakenBody(zoo::moved(mesh, {512, -1024, 256}), 0, 7)}});
  CHECK(there.bodies.volume[0] == Approx(here.bodies.volume[0]).epsilon(1e-11));
}
