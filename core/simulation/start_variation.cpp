
#include "simulation/start_variation.h"

#include <algorithm>

#include "base/random.h"
#include "simulation/start_cells.h"

namespace morula {
namespace {

StartCell moved(StartCell cell, const Vector& by) {
  cell.at += by;
  return cell;
}

/// Moves a start cell as far as it stays in the shell, or no farther out than it stood: an icosphere's vertices lie a
/// little outside of the sphere that it stands for.
StartCell movedWithin(const StartCell& cell, const Vector& by, const MechanicsScene& scene) {
  if (!scene.physics.shell) return moved(cell, by);
  const auto outermost = [&](const StartCell& c) { return outermostSquare(c, scene.mesh, *scene.physics.shell); };
  const double bound = std::max(1.0, outermost(cell));
  if (outermost(moved(cell, by)) <= bound) return moved(cell, by);
  double low = 0, high = 1;  // shares of the way: one that stays inside, and one that does not
  for (int turn = 0; turn < 50; ++turn) {
    const double middle = 0.5 * (low + high);
    (outermost(moved(cell, middle * by)) <= bound ? low : high) = middle;
  }
  return moved(cell, low * by);
}

}  // namespace

std::vector<StartCell> placeStart(const Scene& scene, std::span<const CellPath> paths) {
  std::vector<StartCell> cells = scene.cells;
  if (scene.variation.start == 0) return cells;
  if (cells.empty()) cells.emplace_back();
  const double sd = scene.variation.start * scene.mechanics->physics.cell.radius;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Draw draw{scene.seed, paths[i], 0, Purpose::startVariation};
    const Vector by{randomDeviate(draw, 0), randomDeviate(draw, 1), randomDeviate(draw, 2)};
    cells[i] = movedWithin(cells[i], sd * by, *scene.mechanics);
  }
  return cells;
}

double outermostSquare(const StartCell& cell, const Mesh& egg, const ShellParameters& shell) {
  double outermost = 0;
  for (const Point& vertex : egg.vertices) {
    const Point p = placeVertex(cell, vertex);
    if (shell.mesh) {
      const double reach = measureReach(shell.mesh->planes, p);
      outermost = std::max(outermost, reach * reach);
      continue;
    }
    const Vector q{p.x / shell.semiAxes[0], p.y / shell.semiAxes[1], p.z / shell.semiAxes[2]};
    outermost = std::max(outermost, dot(q, q));
  }
  return outermost;
}

}  // namespace morula
