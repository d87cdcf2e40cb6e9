#pragma once
// Observations, or results from elsewhere, for an organism to be compared with: which of its cells touch, and where
// they lie. Nothing in a reference changes what the cells do.
#include <map>
#include <set>
#include <utility>

#include "base/cell_path.h"
#include "base/vec3.h"

namespace morula {

struct Reference {
  std::set<std::pair<CellPath, CellPath>> contacts;  // (a, b) with a < b; all contacts of every cell that occurs
  std::map<CellPath, Point> positions;               // of centres; any unit of length, any frame
};

}  // namespace morula
