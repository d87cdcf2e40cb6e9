#pragma once
// Meshes whose vertices are some of a finer mesh's, as an icosphere's are of the next level's: a shape on the
// finer mesh has one on the coarser, its restriction.
#include <cstdint>
#include <vector>

#include "mesh/measures.h"

namespace morula {

/// Two meshes of one shape, the coarser one's vertices among the finer one's: for each vertex of `coarse` the
/// vertex of `fine` that it is, found as the nearest, so neither order nor a difference in size counts.
std::vector<std::int32_t> findNested(Points coarse, Points fine);

/// The shape `fine` on a coarser mesh: the vertices `nested`, moved and scaled as one so that volume and mean of the
/// vertices are `fine`'s. Where longer edges cut off so many rims and ridges that nearly 1 % of the area would be lost,
/// these are displaced outwards first, within bounds. If the vertices enclose no volume, they are only moved.
std::vector<Point> restrictShape(Points fine, Faces fineFaces, const std::vector<std::int32_t>& nested,
                                 Faces coarseFaces);

}  // namespace morula
