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

/// A vertex touches the cell of its nearest facing neighbour within reach when its gap to it is below a
/// quarter of the influence radius; it stands for a third of the area of its faces. Area of a pair: the mean
/// of the two sides. Two spheres that overlap touch over the disc in which their surfaces meet. From the last
/// snapshot; by (a, b).
std::vector<ContactArea> measureContactAreas(const Contacts& contacts, const Bodies& bodies);

}  // namespace morula
