// Unequal cuts: the plane stands where the daughter on its far side gets the share that was asked for.
#include "division/place_plane.h"

#include "base/maths.h"
#include "catch.h"
#include "cuts.h"

using namespace morula;

namespace {

double randomIn(double low, double high, std::uint64_t seed, std::uint32_t number) {
  return low + (high - low) * randomUnit({seed, {}, 1, Purpose::test}, number);
}

/// Returns a sphere's mesh with vertices pressed by random planes: convex, without symmetry.
Mesh pressed(std::uint64_t seed) {
  Mesh mesh = zoo::scaled(makeIcosphere(2), {randomIn(0.8, 1.3, seed, 0), 1, randomIn(0.8, 1.3, seed, 1)});
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Vector n = randomDirection({seed, {}, k, Purpose::test});
    const double height = randomIn(0.75, 0.95, seed, 2 + k);
    for (Point& x : mesh.vertices)
      if (const double over = dot(x, n) - height; over > 0) x -= over * n;
  }
  return zoo::moved(mesh, {3, -2, 1});
}

CutResult cutAt(const Body& mother, const Mesh& mesh, const Vector& normal, double share) {
  const Point point = placePlane(mother.position, mesh.faces, normal, share);
  return cutBody(mother, mesh.faces, {point, normal, share}, 1.26);
}

double shareOf(const CutResult& cut, const Mesh& mesh) {
  const double a = measureVolume(cut.daughters.a.position, mesh.faces);
  return a / (a + measureVolume(cut.daughters.b.position, mesh.faces));
}

}  // namespace

TEST_CASE("A box is cut where its length is shared out") {
  const Mesh mesh = zoo::box({-1, -2, -3}, {4, 2, 3});
  for (const double share : {0.1, 0.3, 0.5, 0.75, 0.9}) {
    CAPTURE(share);
    CHECK(placePlane(mesh.vertices, mesh.faces, {1, 0, 0}, share).x == Approx(4 - 5 * share).margin(1e-12));
    CHECK(placePlane(mesh.vertices, mesh.faces, {-1, 0, 0}, share).x == Approx(-1 + 5 * share).margin(1e-12));
    CHECK(placePlane(mesh.vertices, mesh.faces, {0, 1, 0}, share).y == Approx(2 - 4 * share).margin(1e-12));
  }
}

TEST_CASE("A pyramid is cut where a smaller one like it has the share") {
  // Base 2 × 2 at z = 0, tip at z = 3. Projecting the base's corners makes the tip's part wider than a slice: above
  // height t it is a pyramid on the whole base with height 3 − t.
  const Mesh mesh{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 3}},
                  {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  for (const double share : {0.2, 0.5, 0.8}) {
    const Point on = placePlane(mesh.vertices, mesh.faces, {0, 0, 1}, share);
    CHECK(on.z == Approx(3 * (1 - share)).margin(1e-12));  // ⅓ · 4 · (3 − t) of ⅓ · 4 · 3
  }
}

TEST_CASE("Of a ball it is the cap with this share") {
  const Mesh mesh = makeIcosphere(4);
  for (const double share : {0.1, 0.25, 0.5, 0.7}) {
    const Point on = placePlane(mesh.vertices, mesh.faces, {0, 0.6, 0.8}, share);
    const double h = 1 - dot(on, {0, 0.6, 0.8});  // height of the cap: V = π h² (3 − h)/3
    CHECK(h * h * (3 - h) / 4 == Approx(share).margin(0.003));
  }
}

TEST_CASE("Daughters of convex bodies get the volumes that were asked for, and everything else by the share") {
  int exact = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Mesh mesh = pressed(seed);
    Body mother = shakenBody(mesh, 0, 1);
    mother.mass = 3;
    const Vector normal = randomDirection({seed, {}, 9, Purpose::test});
    const double share = randomIn(0.1, 0.9, seed, 9);
    CAPTURE(seed, share);
    const CutResult cut = cutAt(mother, mesh, normal, share);
    REQUIRE(cut.failure == "");
    const auto& [a, b] = cut.daughters;
    const double whole = measureVolume(mother.position, mesh.faces);
    // The share of an unfolded side jumps a little as the plane passes a vertex.
    CHECK(std::abs(shareOf(cut, mesh) - share) < 0.01);
    exact += std::abs(shareOf(cut, mesh) - share) < 1e-9;
    CHECK(measureVolume(a.position, mesh.faces) + measureVolume(b.position, mesh.faces) > 0.95 * whole);
    // Mass and contents, which decide the volume at rest, have the share to the last digit.
    CHECK(a.mass == Approx(3 * share).epsilon(1e-15));
    CHECK(a.pressureConstant == Approx(share * mother.pressureConstant).epsilon(1e-15));
    CHECK(a.mass + b.mass == 3);
    CHECK(a.pressureConstant + b.pressureConstant == Approx(mother.pressureConstant).epsilon(1e-15));
    CHECK(a.velocity == mother.velocity);
    CHECK(b.velocity == mother.velocity);
    CHECK(a.restScale / b.restScale == Approx(cubeRoot(share) / cubeRoot(1 - share)).epsilon(1e-14));
    CHECK(norm(momentumOf(a) + momentumOf(b) - momentumOf(mother)) < 1e-14);
  }
  CHECK(exact > 45);
}

TEST_CASE("Turned about, the other daughter gets the share") {
  const Mesh mesh = pressed(5);
  const Vector normal{0, 0.8, 0.6};
  const Point a = placePlane(mesh.vertices, mesh.faces, normal, 0.3);
  const Point b = placePlane(mesh.vertices, mesh.faces, -normal, 0.7);
  CHECK(dot(a - b, normal) == Approx(0).margin(1e-10));
}

TEST_CASE("Moving, turning and scaling the body moves, turns and scales the plane") {
  const Mesh mesh = pressed(2);
  const Vector normal{0.36, 0.48, 0.8};
  const double height = dot(placePlane(mesh.vertices, mesh.faces, normal, 0.35), normal);
  Mesh other = mesh;  // (x, y, z) → (z, x, y), a turn; twice as large, and elsewhere
  for (Point& x : other.vertices) x = 2 * Point{x.z, x.x, x.y} + Point{1, 2, 3};
  const Vector turned{normal.z, normal.x, normal.y};
  const double its = dot(placePlane(other.vertices, other.faces, turned, 0.35), turned);
  CHECK(its == Approx(2 * height + dot(Point{1, 2, 3}, turned)).epsilon(1e-11));
}

TEST_CASE("A dented body is cut near the share") {
  Mesh mesh = makeIcosphere(3);
  for (Point& x : mesh.vertices)
    if (x.z > 0.3) x.z = 0.6 - x.z;  // a bowl
  const Body mother = shakenBody(mesh, 0, 1);
  for (const double share : {0.3, 0.5, 0.6}) {
    const CutResult cut = cutAt(mother, mesh, {0.8, 0, 0.6}, share);
    CAPTURE(share);
    if (cut.failure.empty()) CHECK(shareOf(cut, mesh) == Approx(share).margin(0.03));
  }
}

TEST_CASE("Rounding does not decide where the share jumps: a body and its mirror image are cut alike") {
  int jumps = 0;
  Worst apart;
  for (std::uint64_t seed = 0; seed < 160; ++seed) {
    const Mesh mesh = pressed(seed);
    Mesh image = mesh;
    for (Point& x : image.vertices) x = {x.x, -x.y, x.z};
    for (Face& f : image.faces) std::swap(f[1], f[2]);
    const Body mother = shakenBody(mesh, 0, 0);
    Body other = shakenBody(image, 0, 0);
    for (std::uint32_t v = 0; v < other.position.size(); ++v) other.position[v] += 1e-13 * noiseVector(v, seed);
    const Vector n = randomDirection({seed, {}, 9, Purpose::test});
    const CutResult cut = cutAt(mother, mesh, n, 0.2), twin = cutAt(other, image, {n.x, -n.y, n.z}, 0.2);
    REQUIRE(cut.failure.empty());
    jumps += std::abs(shareOf(cut, mesh) - 0.2) > 1e-6;
    for (std::size_t v = 0; v < other.position.size(); ++v) {
      const Point x = twin.daughters.a.position[v], y = twin.daughters.b.position[v];
      apart.see(norm(cut.daughters.a.position[v] - Point{x.x, -x.y, x.z}));
      apart.see(norm(cut.daughters.b.position[v] - Point{y.x, -y.y, y.z}));
    }
  }
  CHECK(jumps > 5);
  CHECK(apart < 1e-8);
}
