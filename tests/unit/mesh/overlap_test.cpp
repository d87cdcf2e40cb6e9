#include "mesh/overlap.h"

#include <numbers>

#include "catch.h"
#include "zoo.h"

using namespace morula;

namespace {

using std::numbers::pi;

Overlap overlapOf(const std::vector<Mesh>& meshes, int columns) {
  std::vector<MeshView> views;
  for (const Mesh& m : meshes) views.push_back({m.vertices, m.faces});
  return measureOverlap(views, columns);
}

// Returns the volume common to unit spheres with centres at distance d.
double lens(double d) { return pi * (4 + d) * (2 - d) * (2 - d) / 12; }

}  // namespace

TEST_CASE("Boxes on the lines' grid are measured exactly") {
  // There are 8 × 8 lines over [0, 8]², one per unit square.
  const std::vector<Mesh> boxes = {zoo::box({0, 0, 0}, {4, 4, 4}), zoo::box({2, 2, 1}, {6, 6, 3}),
                                   zoo::box({6, 6, 0}, {8, 8, 9})};
  const Overlap o = overlapOf(boxes, 8);
  CHECK(o.volumes == std::vector<double>{64, 32, 36});
  CHECK(o.shares == std::vector<double>{8.0 / 64, 8.0 / 32, 0});  // 2 × 2 × 2 in common
  CHECK(o.unionVolume == 64 + 32 + 36 - 8);
  CHECK(o.meanShare() == (0.125 + 0.25) / 3);
}

TEST_CASE("Three boxes at one place are counted once in the union and not thrice in a share") {
  const Mesh box = zoo::box({0, 0, 0}, {4, 4, 4});
  const Overlap o = overlapOf({box, box, zoo::box({0, 0, 2}, {4, 4, 6})}, 4);
  CHECK(o.shares == std::vector<double>{1, 1, 0.5});
  CHECK(o.unionVolume == 96);
}

TEST_CASE("Boxes that touch share nothing") {
  for (const Vector& by : {Vector{4, 0, 0}, Vector{0, 4, 0}, Vector{0, 0, 4}, Vector{4, 4, 4}}) {
    const Mesh box = zoo::box({0, 0, 0}, {4, 4, 4});
    const Overlap o = overlapOf({box, zoo::moved(box, by)}, 8);
    CHECK(o.shares == std::vector<double>{0, 0});
    CHECK(o.unionVolume == 128);
  }
}

TEST_CASE("Two spheres overlap by a lens, the better the finer the mesh and the denser the lines") {
  for (double d : {0.5, 1.0, 1.5}) {
    CAPTURE(d);
    // Each axis is tested, for the lines have a direction.
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      double before = 1;
      for (int level = 1; level <= 4; ++level) {
        const Mesh m = makeIcosphere(level);
        const Overlap o = overlapOf({m, zoo::moved(m, d * axis)}, 256);
        const double error = std::abs(o.shares[0] * o.volumes[0] - lens(d)) / (4 * pi / 3);
        CHECK(error < 0.5 * before);
        before = error;
        CHECK(o.shares[0] == Approx(o.shares[1]).margin(2e-3));
        CHECK(o.unionVolume == Approx(o.volumes[0] + o.volumes[1] - o.shares[0] * o.volumes[0]).epsilon(1e-12));
      }
      CHECK(before < 2.5e-3);
    }
  }
}

TEST_CASE("Denser lines find the volume of the mesh itself") {
  for (const auto& [name, mesh, handles] : zoo::all()) {
    if (mesh.vertices.size() > 700) continue;
    CAPTURE(name);
    if (name == "smallest torus") continue;  // the silhouette dominates its volume
    const double exact = zoo::volumeOf(mesh);
    double error = 0;
    for (int columns : {32, 128, 512}) {
      error = std::abs(overlapOf({mesh}, columns).volumes[0] / exact - 1);
      CHECK(error < 1.0 / columns);  // only lines at the silhouette have errors
    }
    CHECK(error < 4e-4);
  }
}

TEST_CASE("Lines through vertices and edges see each body whole") {
  // With an odd number of lines, the middle ones run through corners and along edges of symmetric bodies.
  for (const auto& [name, mesh, handles] : zoo::all())
    for (int columns : {1, 3, 5, 15}) {
      CAPTURE(name, columns);
      REQUIRE_NOTHROW(overlapOf({mesh, zoo::scaled(mesh, {0.5, 0.5, 0.5}), mesh}, columns));
    }
  // All lines go through lattice points of a body whose vertices are lattice points.
  const Mesh diamond{{{-4, 0, 0}, {4, 0, 0}, {0, -4, 0}, {0, 4, 0}, {0, 0, -4}, {0, 0, 4}},
                     {{1, 3, 5}, {3, 0, 5}, {0, 2, 5}, {2, 1, 5}, {3, 1, 4}, {0, 3, 4}, {2, 0, 4}, {1, 2, 4}}};
  const Mesh frame = zoo::box({-4.5, -4.5, -9}, {4.5, 4.5, -8});  // 9 lines at −4, −3, …, 4
  const Overlap o = overlapOf({diamond, frame}, 9);
  // Expected: Σ over |x| + |y| < 4 of 2 (4 − |x| − |y|).
  double sum = 0;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y) sum += 2 * std::max(0, 4 - std::abs(x) - std::abs(y));
  CHECK(o.volumes[0] == sum);
  CHECK(o.volumes[1] == 81);
}

TEST_CASE("Disjoint, nested, identical and inverted bodies") {
  const Mesh ball = makeIcosphere(2);
  const double volume = zoo::volumeOf(ball);

  const Overlap apart = overlapOf({ball, zoo::moved(ball, {0, 0, 2.5})}, 128);
  CHECK(apart.shares == std::vector<double>{0, 0});
  CHECK(apart.unionVolume == Approx(2 * volume).epsilon(1e-3));

  const Overlap nested = overlapOf({ball, zoo::scaled(ball, {0.5, 0.5, 0.5})}, 128);
  CHECK(nested.shares[0] == Approx(1.0 / 8).epsilon(1e-2));
  CHECK(nested.shares[1] == 1);
  CHECK(nested.unionVolume == nested.volumes[0]);

  const Overlap same = overlapOf({ball, ball}, 128);
  CHECK(same.shares == std::vector<double>{1, 1});
  CHECK(same.unionVolume == same.volumes[0]);

  const Overlap inverted = overlapOf({zoo::inverted(ball), ball}, 128);
  CHECK(inverted.volumes[0] == 0);
  CHECK(inverted.shares == std::vector<double>{0, 0});
}

TEST_CASE("A lattice of balls: each share is the sum of its lenses") {
  // In 4 × 4 × 4 unit balls at distance 1.8, neighbours overlap in a lens, and no three balls meet.
  std::vector<Mesh> balls;
  std::vector<int> neighbours;
  for (int i = 0; i < 64; ++i) {
    const int c[3] = {i % 4, i / 4 % 4, i / 16};
    balls.push_back(zoo::moved(makeIcosphere(3), {1.8 * c[0], 1.8 * c[1], 1.8 * c[2]}));
    int n = 0;
    for (int k : c) n += (k > 0) + (k < 3);
    neighbours.push_back(n);
  }
  const Overlap o = overlapOf(balls, 400);
  double sum = 0;
  for (int i = 0; i < 64; ++i) {
    // The balls' meshes are 0.2 % of a radius too flat, which is 4 % of a lens of height 0.1.
    CHECK(o.shares[i] * (4 * pi / 3) == Approx(neighbours[i] * lens(1.8)).epsilon(0.12));
    sum += o.volumes[i];
  }
  CHECK(o.unionVolume == Approx(64 * 4 * pi / 3 - 144 * lens(1.8)).epsilon(0.012));
  CHECK(o.unionVolume < sum);
}

TEST_CASE("Without bodies, or with flat ones, there is nothing to measure") {
  const Overlap none = measureOverlap({}, 16);
  CHECK(none.unionVolume == 0);
  CHECK(none.meanShare() == 0);
  const Overlap flat = overlapOf({zoo::scaled(makeIcosphere(1), {0, 1, 1})}, 16);
  CHECK(flat.volumes == std::vector<double>{0});
  CHECK(flat.shares == std::vector<double>{0});
}
