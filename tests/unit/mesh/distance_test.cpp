// Surfaces of known distance.
#include "mesh/distance.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "scenes.h"

using namespace morula;

TEST_CASE("A surface is nowhere from itself, however its vertices are numbered") {
  const Mesh ball = makeIcosphere(2);
  CHECK(measureSurfaceDistance(ball, ball) == 0);
  Mesh other = ball;
  const auto last = static_cast<std::int32_t>(ball.vertices.size()) - 1;
  std::reverse(other.vertices.begin(), other.vertices.end());
  for (Face& f : other.faces)
    for (std::int32_t& v : f) v = last - v;
  CHECK(measureSurfaceDistance(ball, other) < 1e-15);
}

TEST_CASE("Of concentric cubes half the distances are to faces and half to corners") {
  const Mesh inner = scenes::cube(), outer = scenes::scaled(scenes::cube(), 1.1);
  // Corners of the inner cube are 0.055 under three faces; corners of the outer cube are √3 times as far from a corner.
  CHECK(measureSurfaceDistance(inner, outer) == Approx(0.055 * std::sqrt((1 + 3) / 2.0)).epsilon(1e-12));
  CHECK(measureSurfaceDistance(outer, inner) == Approx(0.055 * std::sqrt((1 + 3) / 2.0)).epsilon(1e-12));
}

TEST_CASE("Distances stand in the order of the vertices they are measured from") {
  Mesh dented = scenes::cube();
  dented.vertices[3] = 1.1 * dented.vertices[3];
  const std::vector<double> distances = measureDistances(dented, scenes::cube());
  REQUIRE(distances.size() == 8);
  for (std::size_t v = 0; v < 8; ++v)
    CHECK(distances[v] == Approx(v == 3 ? 0.1 * norm(scenes::cube().vertices[3]) : 0).margin(1e-12));
}

TEST_CASE("Far apart, surfaces are as far as their nearest corners, edges and faces") {
  const Mesh cube = scenes::cube();  // edges of 1.1
  // Far corners are 3.1 from the other cube's near face, near corners 3.1 − 1.1.
  const double expected = std::sqrt((2.0 * 2.0 + 3.1 * 3.1) / 2);
  CHECK(measureSurfaceDistance(cube, zoo::moved(cube, {3.1, 0, 0})) == Approx(expected).epsilon(1e-12));
}

TEST_CASE("A finer mesh of the same ball is as near as its faces are flat") {
  const Mesh coarse = makeIcosphere(1), fine = makeIcosphere(3);
  const double distance = measureSurfaceDistance(coarse, fine);
  CHECK(distance > 0.01);
  CHECK(distance < 0.08);  // the coarse ball's volume radius is 0.95
  CHECK(measureSurfaceDistance(makeIcosphere(2), fine) < 0.4 * distance);
}

TEST_CASE("Small shifts come out to the last digits") {
  const Mesh cube = scenes::cube();
  // Along an axis four of eight corners leave each cube's face by 1e-9, and the others stay on its surface.
  const double distance = measureSurfaceDistance(cube, zoo::moved(cube, {1e-9, 0, 0}));
  CHECK(distance > 0.5e-9);
  CHECK(distance < 1.001e-9);
}

TEST_CASE("Of balls that overlap the deepest vertex is as deep as the balls, less what faces lie below their sphere") {
  const Mesh ball = makeIcosphere(3);
  for (const Vector& way : {Vector{1, 0, 0}, Vector{0, 0.6, -0.8}, Vector{1 / 3.0, 2 / 3.0, 2 / 3.0}})
    for (const double apart : {0.4, 1.2, 1.8}) {
      const double depth = measureDepth(ball, zoo::moved(ball, apart * way));
      const double ofBalls = std::min(apart, 2 - apart);
      CHECK(depth < ofBalls);
      // The nearest vertex lies up to half an edge, 0.08, off the axis, where depth is up to 0.02 less.
      CHECK(depth > ofBalls - 0.03);
    }
  CHECK(measureDepth(ball, zoo::moved(ball, {2.01, 0, 0})) == 0);
  CHECK(measureDepth(ball, zoo::moved(ball, {1.2, 1.2, 1.2})) == 0);  // boxes meet, balls do not
}

TEST_CASE("Inside is where the surface winds around, not what lies in the box") {
  Mesh cube = scenes::cube();
  const Mesh small = scenes::scaled(scenes::cube(), 0.5), tiny = scenes::scaled(scenes::cube(), 0.05);
  const Point corner = cube.vertices[7];
  CHECK(measureDepth(small, cube) == Approx(corner.x / 2));
  CHECK(measureDepth(cube, small) == 0);
  CHECK(measureDepth(zoo::moved(tiny, 0.7 * corner), cube) > 0);
  cube.vertices[7] = {};  // a dent
  CHECK(measureDepth(zoo::moved(tiny, 0.7 * corner), cube) == 0);
}
