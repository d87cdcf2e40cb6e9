#pragma once
// What a shell holds of a cell, for those who measure; the step finds it in shell_surface_kernel.h.
#include <vector>

#include "mesh/mesh.h"
#include "physics/parameters.h"

namespace morula {

/// [vertex] [length] The points of a closed surface that must lie in the shell: y = x − δ ŝ of each vertex that is not
/// inside of a round shell, and the vertex itself elsewhere.
std::vector<Point> measureHeldPoints(const Mesh& surface, const ShellParameters& shell);

}  // namespace morula
