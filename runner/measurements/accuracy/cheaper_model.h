#pragma once
// The cheaper cell models, in place of a scene's own.
#include <vector>

#include "mesh/mesh.h"
#include "physics/parameters.h"

namespace morula {

/// Those that leave out something that the model has.
std::vector<CellModel> cheaperThan(CellModel model);

/// The shape matching that moves like the shell near its lengths and volume at rest:
///
///   k = (k_s ΣL² + 3 k_p + 6 P_0 V) / I              it breathes as fast, x → (1 + ε) x
///   (1 − β) k = 2/5 k_s ΣL² / I,  κ = 2/5 k_d ΣL² / I  it swings as fast at constant volume, and as damped
///
/// with the edges L, the volume V and I = Σ m_p |x|² of the egg, whose vertices lie about the origin. The 2/5
/// is the mean over all directions in which a cell is pulled long: of (e·E e)² for an edge's direction e,
/// 1/5, over |E x|²/|x|², 1/2, with E = diag(1, −½, −½).
ShapeMatchingParameters matchShell(const PhysicsParameters& shell, const Mesh& egg);

}  // namespace morula
