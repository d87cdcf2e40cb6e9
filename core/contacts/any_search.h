#pragma once
// All searches as one type, which only code that finds pairs, or counts their memory, needs to know
// (NeighbourList::search). To add a search: its struct in this file, its name in contact_search.h.
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
