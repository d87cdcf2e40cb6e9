#pragma once
// Chirality: the two halves of a cell that divides turn against each other about its axis [Naganathan et al. 2014;
// Pimpale et al. 2020], and go on to do so as daughters.
//
// The medium around a newborn swirls: it turns about the division axis with
//
//   ω(t) = ± (angle/time) e^(−t/time),    ∫ ω dt = ± angle,    + for daughter A, − for B,
//
// and its drag takes her vertices along: the acceleration drag · (ω × r), r from the mean of her vertices. Where drag
// is large against 1/time a free cell turns by the angle; a cell that others hold turns them, too, or turns less. Seen
// along the axis from behind, a positive angle turns A clockwise and B counter-clockwise. With the axis reversed A is B
// and the picture the same, so the angle's sign is that of a hand and of no direction. The forces on a cell add up to
// zero.
#include "state/world.h"

namespace morula {

/// Finds the living cells that swirl: daughters whose mother's division has chirality [chiralityOf], until eight time
/// constants have passed and 1/3000 of the angle is left. Must be called whenever the living cells have changed.
/// Returns at once if no rule has chirality.
void findSwirls(World& world);

/// Adds the swirls' forces, at the clock's time.
void addSwirlForces(World& world);

}  // namespace morula
