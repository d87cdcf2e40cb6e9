#pragma once
// Meshes whose vertices are a subset of a finer mesh's, as an icosphere's are of the next level's. A shape on the finer
// mesh has a restriction to the coarser mesh.
#include <cstdint>
#include <vector>

#include "mesh/mesh_measures.h"

namespace morula {

/// Returns for each vertex of `coarse` its counterpart in `fine`, found as the nearest. Both meshes have one shape, and
/// the vertices of `coarse` are among those of `fine`. Neither order nor a difference in size matters.
std::vector<std::int32_t> findNested(Points coarse, Points fine);

/// Restricts the shape `fine` to a coarser mesh: takes the vertices `nested`, moved and scaled together so that volume
/// and mean of the vertices are `fine`'s. If longer edges would cut nearly 1 % of the area off rims and ridges, these
/// are displaced outwards first, within bounds. If the vertices enclose no volume, they are only moved.
std::vector<Point> restrictShape(Points fine, Faces fineFaces, const std::vector<std::int32_t>& nested,
                                 Faces coarseFaces);

}  // namespace morula
