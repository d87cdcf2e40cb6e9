#include "tracks/touching.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morula::tracks {
namespace {

constexpr int corners = 96;
constexpr double leastFace = 0.4;  // of the mean face

using Polygon = std::vector<Point>;

/// A linear function of points.
struct Linear {
  Vector slope;
  double constant;
  double operator()(const Point& p) const { return dot(slope, p) + constant; }
};

/// Positive where a point belongs rather to `one` than to `other`.
Linear preference(const Ball& one, const Ball& other) {
  return {2 * (one.centre - other.centre), one.radius * one.radius - other.radius * other.radius -
                                               dot(one.centre, one.centre) + dot(other.centre, other.centre)};
}

/// The section of the ellipsoid by the plane on which `f` is 0, as a polygon; empty: there is none.
Polygon section(const Linear& f, const Point& middle, const std::array<double, 3>& axes) {
  // In lengths of the semi-axes, from the middle, the ellipsoid is the unit ball.
  const Vector slope{f.slope.x * axes[0], f.slope.y * axes[1], f.slope.z * axes[2]};
  const double steep = norm(slope), distance = -f(middle) / steep;
  if (!(std::abs(distance) < 1)) return {};
  const Vector normal = slope / steep;
  const Vector across = cross(normal, std::abs(normal.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0});
  const Vector u = across / norm(across), v = cross(normal, u);
  const double radius = std::sqrt(1 - distance * distance);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    const Vector p = normal * distance + (u * std::cos(turn) + v * std::sin(turn)) * radius;
    polygon.push_back(middle + Vector{p.x * axes[0], p.y * axes[1], p.z * axes[2]});
  }
  return polygon;
}

/// The part of a convex polygon in which `f` is not negative.
Polygon clip(const Polygon& polygon, const Linear& f) {
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i == 0 ? polygon.size() - 1 : i - 1], &q = polygon[i];
    const double before = f(p), here = f(q);
    if ((before < 0) != (here < 0)) inside.push_back(p + (q - p) * (before / (before - here)));
    if (!(here < 0)) inside.push_back(q);
  }
  return inside;
}

double areaOf(const Polygon& polygon) {
  Vector sum{};
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * norm(sum);
}

}  // namespace

std::vector<Face> facesOf(const std::vector<Ball>& balls, const Point& middle, const std::array<double, 3>& axes) {
  std::vector<Face> faces;
  const int n = static_cast<int>(balls.size());
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      if (balls[a].centre == balls[b].centre) continue;
      Polygon polygon = section(preference(balls[a], balls[b]), middle, axes);
      for (int c = 0; c < n && !polygon.empty(); ++c)
        if (c != a && c != b) polygon = clip(polygon, preference(balls[a], balls[c]));
      if (const double area = areaOf(polygon); area > 0) faces.push_back({a, b, area});
    }
  return faces;
}

std::vector<std::pair<int, int>> touching(const std::vector<Ball>& balls, const Point& middle,
                                          const std::array<double, 3>& axes) {
  const auto faces = facesOf(balls, middle, axes);
  double mean = 0;
  for (const Face& face : faces) mean += face.area / static_cast<double>(faces.size());
  std::vector<std::pair<int, int>> pairs;
  for (const Face& face : faces)
    if (face.area > leastFace * mean) pairs.emplace_back(face.a, face.b);
  return pairs;
}

}  // namespace morula::tracks
