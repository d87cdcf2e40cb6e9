#pragma once
// How far a world is from rest:
//
//   r = √(mean over vertices of (|F|/s)²) / mean over cells of p̂     s: a vertex' share of its cell's surface
//   p̂ = max(|p|, 0.1 k_s/R)                                          balls: 0.1 K/R
//
// the root mean square of tractions that are left, over the pressure in cells: the same on any mesh. A cell of radius R
// has the second p̂ where its membrane is stretched by less than 3 %, where its pressure vanishes.
#include <span>

#include "state/world.h"

namespace morula {

/// Returns r. `squares` [slot] [acceleration²]: sum over the cell's vertices.
double residualOf(const World& world, std::span<const double> squares);

/// Returns r by the accelerations that the bodies have.
double measureResidual(const World& world);

}  // namespace morula
