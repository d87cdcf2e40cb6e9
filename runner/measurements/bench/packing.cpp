#include "bench/packing.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/maths.h"

namespace morula {
namespace {

constexpr int rounds = 60;
constexpr double spacing = 1.7;  // [share radii] wanted between centres; 1.81 is the densest that spheres can

double fraction(double a) { return a - std::floor(a); }

/// Points of the recurrence with the steps 1/g, 1/g², 1/g³, g⁴ = g + 1: as even as an endless sequence can be.
std::vector<Point> spreadPoints(int count, double radius) {
  constexpr double g = 1.2207440846057596;
  std::vector<Point> points;
  for (int i = 1; static_cast<int>(points.size()) < count; ++i) {
    const Point p{2 * fraction(0.5 + i / g) - 1, 2 * fraction(0.5 + i / (g * g)) - 1,
                  2 * fraction(0.5 + i / (g * g * g)) - 1};
    if (dot(p, p) <= 1) points.push_back(radius * p);
  }
  return points;
}

/// Moves each pair that is too near apart by a quarter of what is missing, all at once. O(count²), once.
void pushApart(std::vector<Point>& points, double distance, double radius) {
  std::vector<Vector> move(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Vector d = points[j] - points[i];
      const double square = dot(d, d);
      if (square >= distance * distance || square == 0) continue;
      const Vector push = (0.25 * (distance / std::sqrt(square) - 1)) * d;
      move[i] -= push;
      move[j] += push;
    }
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += move[i];
    const double r = norm(points[i]);
    if (r > radius) points[i] = (radius / r) * points[i];
  }
}

void nameByHalving(std::span<Point> points, const CellPath& path, std::vector<PlacedCell>& cells) {
  if (points.size() == 1) {
    cells.push_back({path, points[0]});
    return;
  }
  Point low = points[0], high = points[0];
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector side = high - low;
  const auto along = [&](const Point& p) {
    return side.x >= side.y && side.x >= side.z ? p.x : side.y >= side.z ? p.y : p.z;
  };
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    if (along(a) != along(b)) return along(a) < along(b);
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  const std::size_t half = points.size() / 2;
  nameByHalving(points.first(half), path.daughter(false), cells);
  nameByHalving(points.subspan(half), path.daughter(true), cells);
}

}  // namespace

double shareRadius(int count) { return 1 / cubeRoot(count); }

std::vector<PlacedCell> packBall(int count) {
  const double share = shareRadius(count), radius = count == 1 ? 0 : 1 - 0.75 * share;
  std::vector<Point> points = spreadPoints(count, radius);
  for (int i = 0; i < rounds; ++i) pushApart(points, spacing * share, radius);
  std::vector<PlacedCell> cells;
  nameByHalving(points, CellPath{}, cells);
  return cells;
}

}  // namespace morula
