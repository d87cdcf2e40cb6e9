#pragma once
// Several cells at time 0 instead of one egg.
#include <vector>

#include "physics/bodies.h"
#include "state/world.h"

namespace morula {

/// Returns the paths of so many start cells, in the order of the list.
std::vector<CellPath> founderPaths(std::size_t count);

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
