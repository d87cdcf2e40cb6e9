// Superposing one set of points on another: by hand, against random rotations, and never with a mirror image.
#include "division/superposition.h"

#include "catch.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

std::vector<Point> cloud(std::size_t count, std::uint32_t key) {
  std::vector<Point> points;
  for (std::uint32_t i = 0; i < count; ++i)
    points.push_back({noise(3 * i, key), 2 * noise(3 * i + 1, key), 3 * noise(3 * i + 2, key)});
  return points;
}

double leftBy(const Turn& turn, const std::vector<Point>& points, const std::vector<Point>& others) {
  const Point a = measureCentroid(points), b = measureCentroid(others);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector d = others[i] - b - turn(points[i] - a);
    sum += dot(d, d);
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

TEST_CASE("Points that were turned, moved and scaled fit again") {
  for (std::uint32_t key = 1; key < 30; ++key) {
    const auto points = cloud(3 + key, key);
    std::vector<Point> moved, larger;
    for (const Point& p : points) {
      moved.push_back(Turn(key + 50)(p) + Vector{5, -3, 1});
      larger.push_back(7 * moved.back());
    }
    CHECK(superpose(points, moved)->distance < 1e-14);
    CHECK(superpose(points, moved)->shape < 1e-14);
    CHECK(superpose(points, larger)->distance > 1);
    CHECK(superpose(points, larger)->shape < 1e-14);
  }
}

TEST_CASE("By hand: rods of lengths 2 and 4 with a point in the middle of each") {
  const std::vector<Point> rod{{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, upright{{1, 3, 1}, {1, 5, 1}, {1, 7, 1}};
  const auto s = superpose(rod, upright);
  CHECK(s->distance == Approx(std::sqrt(2.0 / 3)));  // 1 off at either end
  CHECK(s->shape < 1e-14);
}

TEST_CASE("No other rotation leaves less") {
  for (std::uint32_t key = 1; key < 6; ++key) {
    const auto points = cloud(12, key), others = cloud(12, key + 1000);
    const double best = superpose(points, others)->distance;
    double least = INFINITY;
    for (std::uint32_t trial = 0; trial < 20000; ++trial)
      least = std::min(least, leftBy(Turn(trial + 7), points, others));
    CHECK(best <= least + 1e-12);
    CHECK(best > least - 0.05);  // one of so many rotations comes near
  }
}

TEST_CASE("A mirror image does not fit, and where there is nothing to turn there is no answer") {
  const auto points = cloud(8, 3);
  std::vector<Point> mirrored;
  for (const Point& p : points) mirrored.push_back({-p.x, p.y, p.z});
  CHECK(superpose(points, mirrored)->distance > 0.1);
  CHECK_FALSE(superpose(cloud(2, 1), cloud(2, 2)));
  CHECK_FALSE(superpose(std::vector<Point>(4, {1, 2, 3}), cloud(4, 2)));
  CHECK_FALSE(superpose(cloud(4, 2), std::vector<Point>(4, {1, 2, 3})));
}
