#pragma once
// The ways to search as one type, which only what finds pairs and what counts their memory needs to know
// (NeighbourList::search). To add one: its struct here, its name in contact_search.h.
#include <variant>

#include "contacts/aabb_tree.h"
#include "contacts/brute_force.h"
#include "contacts/grid.h"
#include "contacts/spatial_hash.h"

namespace morula {

struct AnySearch {
  std::variant<GridSearch, TreeSearch, SpatialHash, BruteForce> way;
};

}  // namespace morula
