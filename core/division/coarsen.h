#pragma once
// Level of detail: a cell that has become small takes a coarser mesh, and so costs less.
#include "physics/bodies.h"

namespace morula {

/// Returns the body on the coarsest of the scene's meshes whose mean edge at rest is no longer than
/// physics.mesh.coarsen; unchanged if it has that mesh already, or if the scene has one mesh only. A body whose area
/// would change by more than 1 %, as that of a crumpled one, keeps its mesh; its daughters are tried anew.
///
/// Volume, centre of mass, mass, k_p and momentum stay. All meshes of a scene enclose one volume at rest, so
/// the rest scale stays, too: a round cell of equal volume has equal strain in its membrane, and a lattice of
/// springs is as stiff whatever their length.
Body coarsen(const Bodies& bodies, Body body);

}  // namespace morula
