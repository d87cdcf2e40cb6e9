// Surfaces that nearly cut through themselves, against a test of all pairs of their triangles, and some with known
// shares.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "catch.h"
#include "mesh/folds.h"
#include "self_overlap.h"
#include "zoo.h"

using namespace morula;

namespace {

/// Returns true if the straight line from `from` to `to` passes through the triangle.
bool passesThrough(const Point& from, const Point& to, const Point& a, const Point& b, const Point& c) {
  const Vector way = to - from, normal = cross(b - a, c - a);
  const double before = dot(from - a, normal), after = dot(to - a, normal);
  if ((before > 0) == (after > 0)) return false;
  const Point at = from + (before / (before - after)) * way;
  return dot(cross(b - a, at - a), normal) > 0 && dot(cross(c - b, at - b), normal) > 0 &&
         dot(cross(a - c, at - c), normal) > 0;
}

/// The oracle: returns true if any two triangles without a common vertex cut each other.
bool cutsItself(const Mesh& m) {
  const auto apart = [](const Face& f, const Face& g) {
    return std::ranges::none_of(f, [&](int v) { return std::ranges::find(g, v) != g.end(); });
  };
  for (const Face& f : m.faces)
    for (const Face& g : m.faces)
      if (apart(f, g))
        for (int k = 0; k < 3; ++k)
          if (passesThrough(m.vertices[f[k]], m.vertices[f[(k + 1) % 3]], m.vertices[g[0]], m.vertices[g[1]],
                            m.vertices[g[2]]))
            return true;
  return false;
}

}  // namespace

TEST_CASE("Shapes that are concave, and do not cut through themselves, overlap nowhere") {
  const Mesh ball = makeIcosphere(2);
  std::uint32_t key = 0;
  for (const double angle : {1.0, 3.0, 4.0, 4.6})
    for (int turn = 0; turn < 3; ++turn) {
      const Mesh m = zoo::turned(zoo::bent(ball, angle), ++key);
      CAPTURE(angle, turn);
      CHECK(!cutsItself(m));
      CHECK(selfOverlapOf(m) == Approx(0).margin(1e-12));
    }
  for (const double depth : {0.5, 1.0, 1.5, 1.9})
    for (int turn = 0; turn < 3; ++turn) {
      const Mesh m = zoo::turned(zoo::dented(ball, depth), ++key);
      CAPTURE(depth, turn);
      CHECK(!cutsItself(m));
      CHECK(selfOverlapOf(m) == Approx(0).margin(1e-12));
    }
}

TEST_CASE("All of an inside-out ball is covered inside out, and all of a sphere that is wound twice is covered twice") {
  CHECK(selfOverlapOf(zoo::inverted(makeIcosphere(1))) == 1);
  Mesh twice{{{0.01, 0.02, 1}, {0.01, 0.02, -1}}, {}};
  constexpr int around = 12;  // vertices around, in two rounds
  for (int i = 0; i < around; ++i) {
    const double angle = 0.1 + 2 * std::numbers::pi * 2 * i / around;
    twice.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    const int here = 2 + i, next = 2 + (i + 1) % around;
    twice.faces.push_back({0, here, next});
    twice.faces.push_back({1, next, here});
  }
  CHECK(selfOverlapOf(twice) == Approx(1).epsilon(1e-12));
  CHECK(!isStarShaped(twice));
}

TEST_CASE("Convex shapes are star-shaped, and bent and dented ones are not") {
  for (int level = 0; level <= 3; ++level) CHECK(isStarShaped(makeIcosphere(level)));
  CHECK(isStarShaped(zoo::scaled(makeIcosphere(2), {1, 2, 0.1})));
  CHECK(isStarShaped(zoo::box({0, 0, 0}, {1, 2, 3})));
  CHECK(!isStarShaped(zoo::inverted(makeIcosphere(2))));
  CHECK(!isStarShaped(zoo::bent(makeIcosphere(2), 4)));
  CHECK(!isStarShaped(zoo::dented(makeIcosphere(2), 1.5)));
}

TEST_CASE("Folds: all edges of a tetrahedron, none of a box, the rim of a disc") {
  const auto foldedShare = [](const Mesh& m) {
    const EdgeFaces edges = findEdgeFaces(m.faces);
    return static_cast<double>(countFolded(m.vertices, m.faces, edges)) / static_cast<double>(edges.size());
  };
  CHECK(foldedShare(zoo::tetrahedron()) == 1);  // edges have 109.5°
  CHECK(foldedShare(zoo::box({0, 0, 0}, {1, 2, 3})) == 0);
  CHECK(foldedShare(makeIcosphere(1)) == 0);
  Mesh disc{{{0, 0, 0.01}, {0, 0, -0.01}}, {}};
  for (int i = 0; i < 10; ++i) {
    disc.vertices.push_back({std::cos(0.2 * std::numbers::pi * i), std::sin(0.2 * std::numbers::pi * i), 0});
    const int here = 2 + i, next = 2 + (i + 1) % 10;
    disc.faces.push_back({0, here, next});
    disc.faces.push_back({1, next, here});
  }
  CHECK(findEdgeFaces(disc.faces).size() == 30);
  CHECK(foldedShare(disc) == Approx(1.0 / 3));
}
