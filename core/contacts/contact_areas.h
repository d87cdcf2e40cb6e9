#pragma once
// The cells that touch, and the areas of their contacts.
#include <vector>

#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// Two cells that touch, and the area [length²] over which they touch.
struct ContactArea {
  int a, b;  // cell numbers, a < b
  double area;
};

/// Returns all contacts by (a, b), from the last snapshot. The area of a pair is the mean of its two sides. A side's
/// area is F/p: the force on its vertices where surfaces overlap, over the mean of both cells' pressures. Where cells
/// stick, attraction holds vertices at the contact's edge that nothing presses on, so F/p is too small by half an edge
/// all round. The area is then
///
///   (F + σ C)/(p + σ),   σ = 3 W/A,   C = Σ a c over vertices, at most 2 F/p
///
/// with c, from 0 to 1, a vertex's share of W, the energy per area of surfaces that touch (less than 0.1 is nothing).
/// So C is the area on which attraction acts. It is too large where gaps are as narrow as attraction is long, which is
/// where pressure outweighs adhesion.
///
/// Less than 0.005 of the smaller cell's surface (that of a sphere with its radius at rest) is no contact. Larger areas
/// are continuous in time, except for daughters: born with flat faces in one plane, they press on each other only some
/// steps later. With the thesis' law, whose forces depend on the time step, a vertex touches the cell of its nearest
/// facing neighbour within reach if its gap to that is below a quarter of the influence radius, and stands for a third
/// of the area of its faces. Two spheres that overlap touch over the disc in which their surfaces meet.
std::vector<ContactArea> measureContactAreas(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
