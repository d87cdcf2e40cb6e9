// The longest direction of a cell, also of cells without one: rounding must not decide where a cell divides.
#include "division/principal_axis.h"

#include "catch.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

std::vector<Point> ellipsoid(double a, double b, double c, const Turn& turn) {
  std::vector<Point> points = zoo::scaled(makeIcosphere(2), {a, b, c}).vertices;
  for (Point& x : points) x = turn(x);
  return points;
}

/// Returns the points in another order, which rounds sums differently.
std::vector<Point> shuffled(std::vector<Point> points, std::uint32_t key) {
  for (std::size_t i = points.size(); i > 1; --i) {
    const auto j =
        static_cast<std::size_t>((noise(static_cast<std::uint32_t>(i), key) + 1) / 2 * static_cast<double>(i));
    std::swap(points[i - 1], points[j]);
  }
  return points;
}

double angleSine(const Vector& a, const Vector& b) { return norm(cross(a, b)) / (norm(a) * norm(b)); }

}  // namespace

TEST_CASE("The axis of a needle is the needle's, and of what is a little longer than wide") {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const Turn turn(seed);
    const Vector axis = principalAxis(ellipsoid(3, 1, 1, turn));
    CHECK(norm(axis) == Approx(1).epsilon(1e-14));
    CHECK(angleSine(axis, turn({1, 0, 0})) < 1e-7);
    CHECK(angleSine(principalAxis(ellipsoid(1.0001, 1, 0.9, turn)), turn({1, 0, 0})) < 1e-6);  // 0.01 % suffices
  }
}

TEST_CASE("A sphere has no longest direction: it is x, in whatever order its points come") {
  for (std::uint32_t i = 0; i < 50; ++i) {
    const Vector axis = principalAxis(shuffled(ellipsoid(1, 1, 1, Turn(i)), i));
    CHECK(norm(axis - Vector{1, 0, 0}) < 1e-9);
  }
}

TEST_CASE("Of a disc it is the direction in the disc nearest to x") {
  for (std::uint32_t i = 0; i < 64; ++i) {
    const Turn turn(i);
    const Vector axis = principalAxis(shuffled(ellipsoid(1, 1, 0.5, turn), i));
    const Vector x{1, 0, 0}, across = turn({0, 0, 1}), nearest = x - dot(x, across) * across;
    if (norm(nearest) < 0.51) continue;  // x is nearly normal to the disc, so y decides
    CHECK(angleSine(axis, nearest) < 1e-9);
    CHECK(dot(axis, nearest) > 0);
  }
  CHECK(norm(principalAxis(zoo::scaled(makeIcosphere(2), {0.5, 1, 1}).vertices) - Vector{0, 1, 0}) < 1e-9);
}

TEST_CASE("Which end is the front does not depend on rounding, along axes and diagonals") {
  for (double y : {-1.0, 0.0, 1.0})
    for (double z : {-1.0, 0.0, 1.0})
      for (double x : {0.0, 1.0}) {
        const Vector along{x, y, z};
        if (norm(along) == 0) continue;
        std::vector<Point> needle;
        for (const Point& v : makeIcosphere(1).vertices)
          needle.push_back(v + 2 * dot(v, along) / dot(along, along) * along);
        const Vector axis = principalAxis(needle);
        CHECK(angleSine(axis, along) < 1e-7);
        for (std::uint32_t i = 0; i < 20; ++i) {
          std::vector<Point> again = shuffled(needle, i);
          for (std::uint32_t k = 0; k < again.size(); ++k) again[k] += 1e-14 * noiseVector(k, i);
          CHECK(dot(principalAxis(again), axis) > 0.99);
        }
      }
}

TEST_CASE("The ratio of the two largest extents is that of an ellipsoid's axes, turned anyhow") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const Turn turn(seed);
    CHECK(extentRatio(ellipsoid(3, 2, 1, turn)) == Approx(1.5).epsilon(1e-12));
    CHECK(extentRatio(ellipsoid(1, 4, 2, turn)) == Approx(2).epsilon(1e-12));
    CHECK(extentRatio(ellipsoid(1.01, 1, 1, turn)) == Approx(1.01).epsilon(1e-12));
    CHECK(extentRatio(ellipsoid(2, 2, 1, turn)) == Approx(1).epsilon(1e-12));  // a disc has no longest extent
    CHECK(extentRatio(ellipsoid(1, 1, 1, turn)) == Approx(1).epsilon(1e-12));
    CHECK(extentRatio(ellipsoid(1, 1, 1, turn)) >= 1);
  }
}

TEST_CASE("The extents of a box's corners are half its edges, the largest first, however it lies") {
  for (std::uint32_t seed = 1; seed < 8; ++seed) {
    const Turn turn(seed);
    std::vector<Point> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back(turn(Vector{i & 1 ? 2. : -2., i & 2 ? 0.5 : -0.5, i & 4 ? 3. : -3.}) + Vector{1, 2, 3});
    const Vector extents = principalExtents(corners);
    CHECK(extents.x == Approx(3).epsilon(1e-12));
    CHECK(extents.y == Approx(2).epsilon(1e-12));
    CHECK(extents.z == Approx(0.5).epsilon(1e-12));
  }
  CHECK(principalExtents(std::vector<Point>{{1, 0, 0}, {-1, 0, 0}}).z == 0);
}
