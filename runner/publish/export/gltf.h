#pragma once
// Surfaces of one time as glTF 2.0 in one binary file (.glb), for browsers, presentations and Blender.
#include <string>

#include "export/surfaces.h"

namespace morula {

/// A mesh and a node for each cell, called by its name or else its path; `extras` of the node: path, state, volume. A
/// material for each state. A root node holds the cells and turns them from z upwards to y upwards, as glTF demands.
/// Positions and smooth normals in single precision; cells with the same mesh share their faces.
std::string glbFile(const ExportedRun& run, const Sample& sample);

}  // namespace morula
