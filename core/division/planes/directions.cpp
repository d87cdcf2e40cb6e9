#include "division/planes/directions.h"

#include <numbers>

#include "base/maths.h"
#include "biology/substance_pattern.h"
#include "division/principal_axis.h"

namespace morula {
namespace {

Point centreOf(const CellContext& cell) { return cell.physical()->getShape().centre; }

}  // namespace

Cut throughCentre(const CellContext& cell, const Vector& normal) { return {centreOf(cell), normal}; }

Vector longestExtent(const CellContext& cell) { return principalAxis(cell.physical()->getShape().surface.vertices); }

Vector longestExtentAcross(const CellContext& cell, const Vector& normal) {
  std::vector<Point> within = cell.physical()->getShape().surface.vertices;
  for (Point& x : within) x -= dot(x, normal) * normal;
  return principalAxis(within);
}

std::optional<Vector> contactDirection(const CellContext& cell, const std::string& substance) {
  Vector sum;
  double areas = 0;
  for (const Neighbour& neighbour : cell.neighbours()) {
    if (!fitsAny(substance, neighbour.cell->substances())) continue;
    const Vector way = centreOf(*neighbour.cell) - centreOf(cell);
    const double distance = norm(way);
    if (!(distance > 0)) continue;  // concentric: no direction
    sum += (neighbour.area / distance) * way;
    areas += neighbour.area;
  }
  if (!(norm(sum) > 1e-6 * areas)) return {};
  return sum / norm(sum);
}

std::optional<Vector> outwardDirection(const CellContext& cell) {
  const BodyShape& shape = cell.physical()->getShape();
  const std::optional<Vector> shell = cell.shell();
  const std::optional<Vector> normal = cell.nearestShellNormal();
  const Vector out = shell || normal ? shape.centre : shape.centre - cell.organismCentre();
  const double radius = cubeRoot(3 * shape.volume / (4 * std::numbers::pi));
  if (!(norm(out) > 0.01 * radius)) return {};
  if (normal) return normal;
  if (!shell) return out / norm(out);
  const Vector slope{out.x / (shell->x * shell->x), out.y / (shell->y * shell->y), out.z / (shell->z * shell->z)};
  return slope / norm(slope);
}

}  // namespace morula
