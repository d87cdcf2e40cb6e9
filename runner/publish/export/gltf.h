#pragma once
// Surfaces of one time as glTF 2.0 in one binary file (.glb), for browsers, presentations and Blender.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// Returns the file: a mesh and a node for each cell, called by its name or else its path, and a material for each
/// state. `extras` of a node hold path, state and volume. A root node turns the cells from z upwards to y upwards, as
/// glTF demands. Positions and smooth normals have single precision; cells with the same mesh share their faces.
std::string glbFile(const ExportedRun& run, const Sample& sample);

}  // namespace morula
