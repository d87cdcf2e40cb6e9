#pragma once
// How crumpled a closed surface is: the edges at which it folds over.
#include <array>
#include <vector>

#include "mesh/mesh_measures.h"

namespace morula {

/// [edge] The numbers of the two faces at each edge of a closed mesh. All meshes with these faces share them.
using EdgeFaces = std::vector<std::array<int, 2>>;

EdgeFaces findEdgeFaces(Faces faces);

/// findEdgeFaces without the edges at which the given mesh already folds over: the sharp rim of a lens is no fold.
EdgeFaces findFlatEdges(Points vertices, Faces faces);

/// Returns the number of these edges at which the surface turns by more than 90°: the normals of both faces point away
/// from each other. An edge of a face without area is not folded.
int countFolded(Points vertices, Faces faces, const EdgeFaces& edges);

}  // namespace morula
