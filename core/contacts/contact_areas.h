#pragma once
// Which cells touch, and over which area.
#include <vector>

#include "physics/bodies.h"

namespace morula {

struct Contacts;

/// Two cells that touch and over which area. [length²]
struct ContactArea {
  int a, b;  // cell numbers, a < b
  double area;
};

/// Force over pressure: what presses on the vertices of either side where surfaces overlap, over the mean of both cells'
/// pressures; area of a pair: the mean of the two sides. Less than 0.005 of the smaller cell's surface (that of a sphere
/// with its radius at rest) is no contact. Above that it is continuous in time, but for daughters: born with flat
/// faces in one plane, they press on each other only some steps later. With the thesis' law, whose forces hang on the time
/// step: a vertex touches the cell of its nearest facing neighbour within reach when its gap to it is below a quarter of
/// the influence radius, and stands for a third of the area of its faces. Two spheres that overlap touch over the disc in
/// which their surfaces meet. From the last snapshot; by (a, b).
std::vector<ContactArea> measureContactAreas(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
