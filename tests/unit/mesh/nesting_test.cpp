// Shapes restricted to a coarser mesh: their vertices, and conserved quantities.
#include "mesh/nesting.h"

#include <numeric>

#include "catch.h"
#include "zoo.h"

using namespace morula;

TEST_CASE("An icosphere's first vertices are the coarser one's, whatever the size") {
  for (int level = 0; level < 4; ++level) {
    const Mesh coarse = zoo::scaled(makeIcosphere(level), {1.05, 1.05, 1.05}), fine = makeIcosphere(level + 1);
    std::vector<std::int32_t> first(coarse.vertices.size());
    std::iota(first.begin(), first.end(), 0);
    CHECK(findNested(coarse.vertices, fine.vertices) == first);
  }
}

TEST_CASE("Nested vertices are found in any order") {
  const Mesh coarse = makeIcosphere(1), fine = makeIcosphere(2);
  std::vector<Point> reversed(fine.vertices.rbegin(), fine.vertices.rend());
  const std::vector<std::int32_t> nested = findNested(coarse.vertices, reversed);
  for (std::size_t v = 0; v < nested.size(); ++v) CHECK(reversed[nested[v]] == coarse.vertices[v]);
}

TEST_CASE("Restriction keeps volume and centre exactly and smooth shapes' area to 0.4 %") {
  const Mesh fine = makeIcosphere(3), coarse = makeIcosphere(2);
  const auto nested = findNested(coarse.vertices, fine.vertices);
  for (const Vector& size : {Vector{1, 1, 1}, Vector{27, 15, 11}, Vector{1, 1, 0.5}, Vector{0.3, 0.3, 1}}) {
    const std::vector<Point> shape = zoo::moved(zoo::scaled(fine, size), {5, -7, 11}).vertices;
    const std::vector<Point> restricted = restrictShape(shape, fine.faces, nested, coarse.faces);
    CAPTURE(size.x, size.y, size.z);
    CHECK(measureVolume(restricted, coarse.faces) == Approx(measureVolume(shape, fine.faces)).epsilon(1e-12));
    CHECK(measureArea(restricted, coarse.faces) == Approx(measureArea(shape, fine.faces)).epsilon(4e-3));
    CHECK(norm(measureCentroid(restricted) - measureCentroid(shape)) < 1e-13 * norm({27, 15, 11}));
  }
}

TEST_CASE("The restriction of a sphere is a sphere") {
  const Mesh fine = makeIcosphere(3), coarse = makeIcosphere(2);
  const std::vector<Point> restricted =
      restrictShape(fine.vertices, fine.faces, findNested(coarse.vertices, fine.vertices), coarse.faces);
  for (std::size_t v = 0; v < restricted.size(); ++v)
    CHECK(norm(restricted[v] / norm(restricted[v]) - coarse.vertices[v]) < 1e-13);
}

TEST_CASE("A crease turned inside out encloses nothing and is left to the caller") {
  const Mesh fine = makeIcosphere(1), coarse = makeIcosphere(0);
  std::vector<Point> flat = zoo::scaled(fine, {1, 1, 0}).vertices;
  const auto nested = findNested(coarse.vertices, fine.vertices);
  const std::vector<Point> restricted = restrictShape(flat, fine.faces, nested, coarse.faces);
  REQUIRE(restricted.size() == coarse.vertices.size());
  for (const Point& x : restricted) CHECK(std::isfinite(norm(x)));
}
