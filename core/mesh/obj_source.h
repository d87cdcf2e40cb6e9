#pragma once
// A Wavefront OBJ as it was written, with the lines that messages about it name.
#include "mesh/validity.h"

namespace morula {

/// Reads as readObj of mesh.h does, but leaves the vertices as given. `source` receives the lines of its parts.
Mesh readObjAsGiven(const std::string& text, const std::string& name, MeshSource& source);

}  // namespace morula
