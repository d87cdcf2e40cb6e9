#pragma once
// A Wavefront OBJ as it was written, with the lines that messages about it name.
#include "mesh/validity.h"

namespace morula {

/// readObj of mesh.h, but with the vertices where the text has them. `source` tells where its parts stand.
Mesh readObjAsGiven(const std::string& text, const std::string& name, MeshSource& source);

}  // namespace morula
