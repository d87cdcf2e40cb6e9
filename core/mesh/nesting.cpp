#include "mesh/nesting.h"

#include <algorithm>

#include "base/error.h"
#include "base/maths.h"

namespace morula {
namespace {

constexpr double enough = 0.992;  // share of the fine area: a shape without wrinkles keeps that much anyway
constexpr double most = 0.5;      // max share of its bulge by which a vertex is displaced; more would turn rims over

/// How far each vertex stands out from the mean of its neighbours: outwards where the surface is convex, not
/// at all where it is flat.
std::vector<Vector> measureBulges(Points vertices, Faces faces) {
  std::vector<Vector> sum(vertices.size());
  std::vector<double> count(vertices.size());
  // Each edge belongs to two faces, so every neighbour counts twice.
  for (const Face& f : faces)
    for (int corner = 0; corner < 3; ++corner) {
      sum[f[corner]] += vertices[f[(corner + 1) % 3]] + vertices[f[(corner + 2) % 3]];
      count[f[corner]] += 2;
    }
  for (std::size_t v = 0; v < vertices.size(); ++v) sum[v] = vertices[v] - sum[v] / count[v];
  return sum;
}

}  // namespace

std::vector<std::int32_t> findNested(Points coarse, Points fine) {
  std::vector<std::int32_t> nested;
  std::vector<char> taken(fine.size());
  for (const Point& x : coarse) {
    const auto isNearer = [&](const Point& a, const Point& b) { return dot(a - x, a - x) < dot(b - x, b - x); };
    const auto nearest = std::min_element(fine.begin(), fine.end(), isNearer) - fine.begin();
    MORULA_CHECK(!taken[nearest], "the vertices of a coarser mesh are those of the finer one");
    taken[nearest] = true;
    nested.push_back(static_cast<std::int32_t>(nearest));
  }
  return nested;
}

std::vector<Point> restrictShape(Points fine, Faces fineFaces, const std::vector<std::int32_t>& nested,
                                 Faces coarseFaces) {
  const double volume = measureVolume(fine, fineFaces), area = measureArea(fine, fineFaces);
  const Point centre = measureCentroid(fine);
  const std::vector<Vector> bulges = measureBulges(fine, fineFaces);
  const auto withBulges = [&](double share) {
    std::vector<Point> coarse;
    for (std::int32_t v : nested) coarse.push_back(fine[v] + share * bulges[v]);
    const double enclosed = measureVolume(coarse, coarseFaces);
    const double scale = enclosed > 0 ? cubeRoot(volume / enclosed) : 1;
    const Point from = measureCentroid(coarse);
    for (Point& x : coarse) x = centre + scale * (x - from);
    return coarse;
  };
  const double without = measureArea(withBulges(0), coarseFaces), with = measureArea(withBulges(most), coarseFaces);
  const bool helps = with > without && without < enough * area;
  return withBulges(helps ? most * std::min((enough * area - without) / (with - without), 1.0) : 0);
}

}  // namespace morula
