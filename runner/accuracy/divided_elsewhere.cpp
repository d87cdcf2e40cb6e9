#include "accuracy/divided_elsewhere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "division/principal_axis.h"
#include "mesh/measures.h"

namespace morula {

namespace {

const ComparedCell* find(const Shapes& shapes, const CellPath& path) {
  const auto cell = std::find_if(shapes.cells.begin(), shapes.cells.end(),
                                 [&](const ComparedCell& c) { return c.path == path; });
  return cell == shapes.cells.end() ? nullptr : &*cell;
}

/// From daughter B to daughter A; absent if one of them does not live.
std::optional<Vector> axisAt(const Shapes& shapes, const CellPath& mother) {
  const ComparedCell *a = find(shapes, mother.daughter(false)), *b = find(shapes, mother.daughter(true));
  if (!a || !b || a->centroid == b->centroid) return {};
  const Vector d = a->centroid - b->centroid;
  return d / norm(d);
}

}  // namespace

double measureExtentRatio(const Mesh& surface) {
  const Point centre = measureCentroid(surface.vertices);
  const Vector first = principalAxis(surface.vertices);
  // Two directions across it: the coordinate axis farthest from it, made perpendicular, and the third.
  const Vector e = std::abs(first.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  Vector u = e - dot(e, first) * first;
  u = u / norm(u);
  const Vector w = cross(first, u);
  double largest = 0, uu = 0, uw = 0, ww = 0;
  for (const Point& x : surface.vertices) {
    const Vector d = x - centre;
    const double along = dot(d, first), a = dot(d, u), b = dot(d, w);
    largest += along * along, uu += a * a, uw += a * b, ww += b * b;
  }
  const double second = (uu + ww) / 2 + std::hypot((uu - ww) / 2, uw);  // the larger eigenvalue of the two
  return second > 0 ? std::sqrt(largest / second) : INFINITY;
}

std::optional<DividedElsewhere> findDividedElsewhere(const Trial& trial, const Trial& reference,
                                                     double least) {
  const std::size_t count = std::min(trial.shapes.size(), reference.shapes.size());
  for (const LineageEntry& mother : reference.born) {  // in order of birth; of division among the same births
    if (mother.fate != Fate::divided) continue;
    for (std::size_t i = 1; i < count; ++i) {
      if (reference.shapes[i].time < mother.ended) continue;
      const auto ours = axisAt(trial.shapes[i], mother.path),
                 theirs = axisAt(reference.shapes[i], mother.path);
      if (!ours || !theirs) break;
      const double cosine = std::min(1.0, std::abs(dot(*ours, *theirs)));
      const double angle = std::acos(cosine) * 180 / std::numbers::pi;
      if (angle < least) break;
      const ComparedCell* before = find(reference.shapes[i - 1], mother.path);
      return DividedElsewhere{mother.path, mother.ended, angle,
                              before ? measureExtentRatio(before->surface) : 0};
    }
  }
  return {};
}

}  // namespace morula
