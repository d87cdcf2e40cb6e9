#pragma once
// Several cells at time 0 instead of one egg.
#include <optional>
#include <string>
#include <vector>

#include "base/members.h"
#include "base/vec3.h"
#include "physics/bodies.h"

namespace morula {

struct World;

/// One of the cells that a scene begins with: the egg at another place, of another size or shape.
struct StartCell {
  Point at = {};            // [length] its centre
  Vector velocity = {};     // [length/time] of all its vertices
  double scale = 1;         // its size at rest over the egg's: lengths; the fluid's k_p and mass go with the cube
  Vector turn = {};         // [degree] turn of its mesh about this axis, by the axis' length; before stretching
  Vector stretch{1, 1, 1};  // of its shape along x, y and z; its shape at rest stays
  std::optional<double> mass = {};                          // [mass]; absent: the egg's times scale³
  std::optional<std::vector<std::string>> substances = {};  // sorted; absent: what the DNA starts with
};
MORULA_MEMBERS(StartCell, at, velocity, scale, turn, stretch, mass, substances)

/// Names the cells that live at time 0 and puts them into the lineage. Several start cells are named as if
/// one egg had divided at time 0 until there were enough: the first half of them, rounded up, descends from
/// daughter A, the others from B, and so on. So their paths are in the order of the list, and no path leads
/// to another. Throws InputError for a substance that the biology does not know.
void createFounders(World& world);

/// Returns the start cells' bodies, in the same order; one egg if there are none.
std::vector<Body> makeStartBodies(const Bodies& bodies, const std::vector<StartCell>& cells);

/// Returns the place at which a start cell has a vertex of the egg's mesh.
Point placeVertex(const StartCell& cell, const Point& ofEgg);

}  // namespace morula
