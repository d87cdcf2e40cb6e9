#pragma once
// What a shell holds of a cell, for those who measure; the step finds it in shell_surface_kernel.h.
#include <vector>

#include "mesh/mesh.h"
#include "physics/parameters.h"

namespace morula {

// [1] of the sag δ: so much it may change from when the shell was felt in a step to the step's end.
constexpr double heldWithin = 0.05;

/// [vertex] [length] The points of a closed surface that must lie in the shell. Where it holds surfaces: y = x − δ ŝ of
/// each vertex that is not inside, or the point on the shell where δ within heldWithin leads there. The vertex itself
/// elsewhere.
std::vector<Point> measureHeldPoints(const Mesh& surface, const ShellParameters& shell);

}  // namespace morula
