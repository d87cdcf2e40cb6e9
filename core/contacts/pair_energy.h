#pragma once
// The pair law (pair_law_kernel.h) once more, one pair at a time and in doubles: for measures, and as an oracle.
#include "contacts/contacts.h"

namespace morula {

/// What vertex i's pairs with vertices of one other cell sum up to, damping and friction left out.
struct PairSum {
  VertexNumber vertex;   // i
  int slot, other;       // of i and of the other cell
  double repulsion = 0;  // [energy] half of the pairs': the other half is that of the vertices j
  double adhesion = 0;   // [energy] the same, at most 0
  double deepest = 0;    // [1] B u (deepestHeld)
  double pressing = 0;   // [force] along h, where the planes of i and j overlap
  Vector force;          // −∂E/∂y_i
};

/// Of all vertices that any other cell's are within reach of: by the cells' numbers, the lower one of the two first,
/// and then by vertex. From the last snapshot.
std::vector<PairSum> sumPairs(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
