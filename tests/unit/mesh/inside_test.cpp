#include "base/random.h"
#include "catch.h"
#include "mesh_oracles.h"
#include "zoo.h"

using namespace morula;

namespace {

bool holds(const Mesh& m, const Point& p) { return isInside(p, m.vertices, m.faces); }

// Returns a random point, uniform in the cube [-1, 1]³.
Point randomPoint(std::uint64_t number) {
  const auto u = [number](std::uint32_t k) { return 2 * randomUnit({number, {}, 0, Purpose::test}, k) - 1; };
  return {u(0), u(1), u(2)};
}

// Returns the cube [0, 1]³ in six tetrahedra, one per order of the axes on the way from corner to corner.
std::vector<Mesh> cubeInSixTetrahedra() {
  std::vector<Mesh> parts;
  for (const auto& [a, b, odd] : {std::tuple{1, 2, 0}, {1, 4, 1}, {2, 1, 1}, {2, 4, 0}, {4, 1, 0}, {4, 2, 1}}) {
    Mesh m;
    for (int corner : {0, a, a | b, 7})
      m.vertices.push_back({corner & 1 ? 1.0 : 0, corner & 2 ? 1.0 : 0, corner & 4 ? 1.0 : 0});
    m.faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    parts.push_back(odd ? zoo::inverted(m) : m);
  }
  return parts;
}

}  // namespace

TEST_CASE("Inside a box, a crumpled ball and a torus") {
  const Mesh box = zoo::box({-0.5, -0.25, -0.75}, {0.5, 0.75, 0.25});
  const Mesh ring = zoo::scaled(zoo::torus(48, 32), {1 / 3.0, 1 / 3.0, 1 / 3.0});
  int inBall = 0;
  const Mesh ball = zoo::scaled(zoo::crumpled(makeIcosphere(3), 0.05, 1), {0.7, 0.7, 0.7});
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const Point p = randomPoint(i);
    REQUIRE(holds(box, p) == (p.x > -0.5 && p.x < 0.5 && p.y > -0.25 && p.y < 0.75 && p.z > -0.75 && p.z < 0.25));
    const double r = norm(p);
    if (r < 0.65) REQUIRE(holds(ball, p));
    if (r > 0.75) REQUIRE(!holds(ball, p));
    inBall += holds(ball, p);
    const double fromRing = std::sqrt(p.x * p.x + p.y * p.y) - 2 / 3.0;
    const double d = std::sqrt(fromRing * fromRing + p.z * p.z) * 3;
    if (d < 0.95) REQUIRE(holds(ring, p));
    if (d > 1.0) REQUIRE(!holds(ring, p));
  }
  CHECK(inBall > 0);
}

TEST_CASE("Parts that tile a cube have each of its points once, on their common faces, edges and corners too") {
  const auto parts = cubeInSixTetrahedra();
  for (const Mesh& part : parts) CHECK_NOTHROW(checkClosedManifold(part, "part"));
  for (int i = 1; i < 8; ++i)
    for (int j = 1; j < 8; ++j)
      for (int k = 1; k < 8; ++k) {
        int count = 0;
        for (const Mesh& part : parts) count += holds(part, {i / 8.0, j / 8.0, k / 8.0});
        REQUIRE(count == 1);
      }
}

TEST_CASE("Nothing is inside an inverted mesh") {
  CHECK(holds(makeIcosphere(1), {0, 0, 0}));
  CHECK(!holds(zoo::inverted(makeIcosphere(1)), {0, 0, 0}));
}
