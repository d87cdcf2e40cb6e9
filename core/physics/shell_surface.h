#pragma once
// Contact with the shell: of one cell, for measures (the step uses shell_kernel.h), and of all cells.
#include "mesh/mesh.h"
#include "physics/parameters.h"

namespace morula {

/// [length] The point below a cell's vertex x that must lie in the shell: where it holds surfaces, in a shell whose
/// half-axes a are longer by the sag δ, x lies where y_i = x_i a_i/(a_i + δ) lies in the shell itself. Else the vertex.
Point heldPoint(const Point& x, const ShellParameters& shell, double sag);

/// [length³] What the shell encloses.
double measureShellVolume(const ShellParameters& shell);

}  // namespace morula
