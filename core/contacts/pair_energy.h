#pragma once
// The pair law (pair_law_kernel.h) one pair at a time and in doubles: for measures, and as an oracle.
#include "contacts/contacts.h"

namespace morula {

/// The sum over vertex i's pairs with vertices of one other cell, without damping and viscosity.
struct PairSum {
  VertexNumber vertex;   // i
  int slot, other;       // of i and of the other cell
  double repulsion = 0;  // [energy] half of the pairs' energy: the vertices j have the other half
  double held = 0;       // [energy] e of adhesion.h with these vertices, at least 0: as if adhesion did not saturate
  double adhesion = 0;   // [energy] −e s(ρ), at most 0
  double deepest = 0;    // [1] B u (deepestHeld)
  double pressing = 0;   // [force] along h, where the planes of i and j overlap
  Vector force;          // −∂E/∂y_i, with the saturation of the last evaluation
};

/// Returns the sums of all vertices that have another cell's vertices within reach. They are sorted by the cells'
/// numbers, the lower one first, and then by vertex. Uses the last snapshot.
std::vector<PairSum> sumPairs(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
