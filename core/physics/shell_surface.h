#pragma once
// Contact with the shell: of one cell, for measures (the step uses shell_kernel.h), and of all cells.
#include "mesh/mesh.h"
#include "physics/parameters.h"

namespace morula {

/// Returns the point [length] that must lie in the shell for a cell's vertex x. If the shell holds vertices: x. If it
/// holds surfaces: y_i = x_i a_i/(a_i + δ), which is in the shell where x is in one with half-axes longer by the sag δ.
Point heldPoint(const Point& x, const ShellParameters& shell, double sag);

/// Returns the volume [length³] that the shell encloses.
double measureShellVolume(const ShellParameters& shell);

}  // namespace morula
