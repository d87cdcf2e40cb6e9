#pragma once
// How far below a cell's vertices the surface is that holds its volume: the surface that shells hold and that contacts
// act on.
//
// Faces cut across a curved surface. What lies δ inside the smooth surface through the vertices, everywhere, encloses
// as much as the mesh does if δ = l²/8 ∮H/A, for edges of length l and mean curvature H: what faces cut off is l²/8 ∮H.
// ∮H of a cell hardly changes when it is pressed flat somewhere (measured, pressed pairs: 4 %), so δ is one number for
// each cell, that of a ball of its size: the egg's δ (measureSag) times the cell's rest scale, times s, its radius over
// that at rest. s follows from what the cell is made of, not from how it lies now: a δ that followed the volume would
// need a force on the volume, too.
//
//   k_p − P_0 V₀ s³ = k_s Σw L₀² s (s − 1)/3        a free cell at rest: pressure against springs [Nilsson 2008, eq. 4.2, 4.3]
//
// Cells whose free volumes together would not fit into their shell share its room, each in proportion to its own. Cells
// without contents under pressure have s = 1.
#include "physics/bodies.h"

namespace morula {

/// [1] s of a cell that nothing touches, from ½ to 2.
double measureFreeScale(const Bodies& bodies, int slot);

/// Sets Bodies::sag. To be called when cells come, go or grow; setBodies does.
void setSags(Bodies& bodies);

}  // namespace morula
