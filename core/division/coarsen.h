#pragma once
// Level of detail: a cell that has become small takes a coarser mesh, and so costs less.
#include "physics/bodies.h"

namespace morula {

/// The body on the coarsest of the scene's meshes whose edges are at rest no longer in the mean than
/// physics.mesh.coarsen; as it is if it has that one already, or if the scene has one mesh only. A body whose area
/// would change by more than 1 %, as that of a crumpled one, keeps its mesh; its daughters are asked anew.
///
/// Volume, centre of mass, mass, k_p and momentum stay. All meshes of a scene enclose one volume at rest, so
/// the rest scale stays, too: a round cell of equal volume has equal strain in its membrane, and a lattice of
/// springs is as stiff whatever their length.
Body coarsen(const Bodies& bodies, Body body);

}  // namespace morula
