#pragma once
// Deviations of the first cells' places, by the seed.
#include <span>

#include "base/cell_path.h"
#include "state/scene.h"

namespace morula {

/// Returns the scene's start cells, or with none and a variation.start the one egg, each displaced by variation.start
/// egg radii times three deviates of its path. A displacement that would lead out of the shell ends where the
/// cell touches it. Requires bodies. `paths`: of the cells, in their order.
std::vector<StartCell> placeStart(const Scene& scene, std::span<const CellPath> paths);

/// Returns the largest (x/a)² + (y/b)² + (z/c)² [1] of the cell's vertices, with the shell's semi-axes: at most 1
/// inside. For a shell that is a mesh, the square of measureReach.
double outermostSquare(const StartCell& cell, const Mesh& egg, const ShellParameters& shell);

}  // namespace morula
