#include <set>

#include "base/hash.h"
#include "catch.h"
#include "mesh/mesh.h"
#include "mesh/mesh_measures.h"
#include "mesh_oracles.h"

using namespace morula;

TEST_CASE("An icosphere has the counts of its level and lies on the unit sphere") {
  const int counts[] = {12, 42, 162, 642, 2562};
  for (int level = 0; level <= 4; ++level) {
    const Mesh m = makeIcosphere(level);
    CAPTURE(level);
    CHECK(m.vertices.size() == static_cast<std::size_t>(counts[level]));
    CHECK(m.faces.size() == static_cast<std::size_t>(2 * counts[level] - 4));
    for (const Point& v : m.vertices) REQUIRE(std::abs(norm(v) - 1) < 4e-16);
    CHECK_NOTHROW(checkClosedManifold(m, "icosphere"));
    CHECK(countFacesTurnedInward(m.vertices, m.faces, {0, 0, 0}) == 0);
  }
}

TEST_CASE("The first vertices of an icosphere are those of the level below") {
  for (int level = 1; level <= 4; ++level) {
    const Mesh coarse = makeIcosphere(level - 1), fine = makeIcosphere(level);
    for (std::size_t i = 0; i < coarse.vertices.size(); ++i) REQUIRE(coarse.vertices[i] == fine.vertices[i]);
  }
}

TEST_CASE("The icosahedron has the volume and area of the closed forms") {
  // For circumradius 1: edge a = 4 / √(10 + 2√5), V = 5 (3 + √5) a³ / 12, A = 5 √3 a².
  const Mesh m = makeIcosphere(0);
  const double a = 4 / std::sqrt(10 + 2 * std::sqrt(5.0));
  CHECK(measureVolume(m.vertices, m.faces) == Approx(5 * (3 + std::sqrt(5.0)) * a * a * a / 12).epsilon(1e-14));
  CHECK(measureArea(m.vertices, m.faces) == Approx(5 * std::sqrt(3.0) * a * a).epsilon(1e-14));
}

TEST_CASE("Icospheres have five edges at the icosahedron's corners and six elsewhere") {
  const Mesh m = makeIcosphere(3);
  std::vector<std::set<int>> neighbours(m.vertices.size());
  for (const Face& f : m.faces)
    for (int k = 0; k < 3; ++k) neighbours[f[k]].insert({f[(k + 1) % 3], f[(k + 2) % 3]});
  for (std::size_t i = 0; i < neighbours.size(); ++i) REQUIRE(neighbours[i].size() == (i < 12 ? 5 : 6));
}

TEST_CASE("The icospheres' triangles stay near equilateral: the springs may take them as equal") {
  for (int level = 0; level <= 4; ++level) {
    const Mesh m = makeIcosphere(level);
    double shortest = INFINITY, longest = 0, sharpest = -1, bluntest = 1;  // lengths of edges, and cosines of corners
    for (const Face& face : m.faces)
      for (int k = 0; k < 3; ++k) {
        const Point& corner = m.vertices[face[k]];
        const Vector u = m.vertices[face[(k + 1) % 3]] - corner, v = m.vertices[face[(k + 2) % 3]] - corner;
        const double cosine = dot(u, v) / (norm(u) * norm(v));
        shortest = std::min(shortest, norm(u)), longest = std::max(longest, norm(u));
        sharpest = std::max(sharpest, cosine), bluntest = std::min(bluntest, cosine);
      }
    CAPTURE(level);
    CHECK(sharpest < (level == 0 ? 0.5 + 1e-14 : 0.6));  // 53°
    CHECK(bluntest > (level == 0 ? 0.5 - 1e-14 : 0.3));  // 72.5°
    CHECK(longest / shortest < (level == 0 ? 1 + 1e-14 : 1.26));
  }
}

TEST_CASE("The bits of the icospheres never change: results of old runs rest on them") {
  const char* const known[] = {"b6af971628377e559cd0f5270f2adf76", "3cb165d9b2933e19d7451a7fc198f096",
                               "14090d45d264f34056914aa6f9279f37", "26f5da2e0c571931d11d0aedf9110799",
                               "1548f6065dae212d90db78dce6cf5955"};
  for (int level = 0; level <= 4; ++level) {
    const Mesh m = makeIcosphere(level);
    Hasher h;
    for (const Point& v : m.vertices) h.add(v.x).add(v.y).add(v.z);
    for (const Face& f : m.faces) h.add(f[0]).add(f[1]).add(f[2]);
    CAPTURE(level);
    CHECK(h.digest().text() == known[level]);
  }
}

TEST_CASE("Other levels are refused with what would be right") {
  for (int level : {-1, 5, 1000}) CHECK_THROWS_WITH(makeIcosphere(level), ContainsSubstring("choose 0 to 4"));
}
