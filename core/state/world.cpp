
#include "state/world.h"

#include <algorithm>

namespace morula {

int cellNumber(const Cells& cells, const CellPath& path) {
  const auto at = std::ranges::lower_bound(cells.path, path);
  return at != cells.path.end() && *at == path ? static_cast<int>(at - cells.path.begin()) : -1;
}

}  // namespace morula
