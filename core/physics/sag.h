#pragma once
// The sag δ: how far below a cell's vertices the surface is that holds its volume. Shells hold this surface, and
// contacts act on it.
//
// Faces cut across a curved surface. A surface everywhere δ inside the smooth surface through the vertices encloses as
// much as the mesh does if δ = l²/8 ∮H/A, for edges of length l and mean curvature H: faces cut off l²/8 ∮H. ∮H of a
// cell hardly changes when it is pressed flat somewhere (measured, pressed pairs: 4 %). So δ is one number for each
// cell, that of a ball of its size: the egg's δ (measureSag) times the cell's rest scale, times s, its radius over its
// radius at rest. s follows from the cell's contents, not from its present shape: a δ that followed the volume would
// need a force on the volume, too.
//
//   k_p − P_0 V₀ s³ = k_s Σw L₀² s (s − 1)/3   a free cell at rest: pressure against springs [Nilsson 2008, eq. 4.2–3]
//
// Cells whose free volumes together would not fit into their shell share its room in proportion to these volumes. Cells
// without contents under pressure have s = 1.
#include "physics/bodies.h"

namespace morula {

/// Returns s [1] of a cell that nothing touches, from ½ to 2.
double measureFreeScale(const Bodies& bodies, int slot);

/// Sets Bodies::sag. Must be called when cells come, go or grow; setBodies calls it.
void setSags(Bodies& bodies);

}  // namespace morula
