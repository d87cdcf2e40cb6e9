// Polygons cut into triangles, against the shoelace formula and brute force.
#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/vec3.h"
#include "catch.h"

using namespace morula;

namespace {

using Polygon = std::vector<Point>;

double shoelace(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double signedArea(const Point& a, const Point& b, const Point& c) { return shoelace({a, b, c}); }

/// Returns true if the point lies in the polygon: a ray along x crosses an odd number of sides.
bool holds(const Polygon& p, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++)
    if ((p[i].y > y) != (p[j].y > y) && x < (p[j].x - p[i].x) * (y - p[i].y) / (p[j].y - p[i].y) + p[i].x)
      inside = !inside;
  return inside;
}

/// Checks that the triangles turn as the polygon does, cover it, and cover nothing else.
void checkCovers(const Polygon& polygon) {
  const Triangulation cut = triangulate(polygon);
  REQUIRE(cut.wrong == "");
  REQUIRE(cut.triangles.size() == polygon.size() - 2);
  const double whole = shoelace(polygon), sign = whole > 0 ? 1 : -1;
  double sum = 0;
  for (const auto& [a, b, c] : cut.triangles) {
    const double area = signedArea(polygon[a], polygon[b], polygon[c]);
    CHECK(sign * area > 0);
    sum += area;
    const double x = (polygon[a].x + polygon[b].x + polygon[c].x) / 3,
                 y = (polygon[a].y + polygon[b].y + polygon[c].y) / 3;
    CHECK(holds(polygon, x, y));
  }
  CHECK(std::abs(sum / whole - 1) < 1e-12);
}

Polygon turned(Polygon p, std::size_t first, bool backwards) {
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(first), p.end());
  if (backwards) std::reverse(p.begin(), p.end());
  return p;
}

/// Returns a star around a point with random radii: simple, and concave nearly everywhere.
Polygon star(std::mt19937& random, int corners) {
  std::uniform_real_distribution<double> radius(0.2, 2);
  Polygon p;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners, r = radius(random);
    p.push_back({r * std::cos(angle) + 3, r * std::sin(angle) - 1, 0});
  }
  return p;
}

}  // namespace

TEST_CASE("A concave polygon is covered once, from each of its corners and both ways round") {
  const std::vector<Polygon> polygons{
      {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},                        // an L
      {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}},  // a U
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}},  // corners on sides
      {{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}},
      {{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {2, 4, 0}},  // an arrow
  };
  for (const Polygon& polygon : polygons)
    for (std::size_t first = 0; first < polygon.size(); ++first)
      for (const bool backwards : {false, true}) checkCovers(turned(polygon, first, backwards));
  std::mt19937 random(7);
  for (int corners = 4; corners < 60; ++corners) checkCovers(star(random, corners));
}

TEST_CASE("A polygon is cut alike wherever it stands in space") {
  const Polygon flat{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  const Vector x{0.48, 0.6, 0.64}, y{0.8, -0.6, -0.0375};
  for (std::size_t first = 0; first < flat.size(); ++first) {
    const Polygon polygon = turned(flat, first, false);
    Polygon placed;
    for (const Point& p : polygon) placed.push_back(Point{5, -2, 1} + x * p.x + y * p.y);
    double area = 0;
    for (const auto& [a, b, c] : triangulate(placed).triangles)
      area += 0.5 * norm(cross(placed[b] - placed[a], placed[c] - placed[a]));
    CHECK(area == Approx(3 * norm(cross(x, y))).epsilon(1e-12));
  }
}

TEST_CASE("A convex polygon keeps the fan around its first corner") {
  const Polygon hexagon{{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
  const std::vector<std::array<int, 3>> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  CHECK(triangulate(hexagon).triangles == fan);
}

TEST_CASE("A polygon that crosses itself, or has no area, has no triangles") {
  for (const Polygon& polygon : {Polygon{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 3, 0}},
                                 Polygon{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {1, -1, 0}, {0, 3, 0}},
                                 Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}) {
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.triangles.empty());
    CHECK(cut.wrong != "");
  }
}
