#include "trees/tree_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/cell_path.h"
#include "base/error.h"

namespace morula {
namespace {

void check(const LineageNode& node) {
  if (node.path.find_first_not_of("AB") != std::string::npos)
    throw InputError("'" + node.path + "' is not a lineage path; it must be made of the letters A and B");
  if (!std::isfinite(node.born) || !std::isfinite(node.ended))
    throw InputError(cellName(node.path) + " is born or ends at a time that is not finite");
  if (node.ended < node.born) throw InputError(cellName(node.path) + " ends before it is born");
}

}  // namespace

TreeLayout layoutTree(const std::vector<LineageNode>& nodes) {
  TreeLayout layout;
  for (const LineageNode& node : nodes) {
    check(node);
    layout.places.push_back({.node = &node});
  }
  std::vector<TreePlace>& places = layout.places;
  std::sort(places.begin(), places.end(),
            [](const TreePlace& a, const TreePlace& b) { return a.node->path < b.node->path; });
  if (places.empty()) return layout;
  layout.begin = places.front().node->born;
  layout.end = places.front().node->ended;
  // The cells from a root down to the last one seen: a path's mother is always among them
  std::vector<int> line;
  for (int i = 0; i < int(places.size()); ++i) {
    const std::string& path = places[i].node->path;
    if (i > 0 && path == places[i - 1].node->path) throw InputError(cellName(path) + " appears twice in the tree");
    while (!line.empty() && !path.starts_with(places[line.back()].node->path)) line.pop_back();
    if (!line.empty() && places[line.back()].node->path.size() + 1 == path.size()) {
      places[i].mother = line.back();
      places[line.back()].daughter[path.back() == 'B'] = i;
    }
    line.push_back(i);
    layout.begin = std::min(layout.begin, places[i].node->born);
    layout.end = std::max(layout.end, places[i].node->ended);
  }
  for (TreePlace& place : places)
    if (place.isLeaf()) place.x = double(layout.leaves++) + 0.5;
  for (std::size_t i = places.size(); i-- > 0;) {  // daughters stand behind their mothers, so they are placed first
    TreePlace& place = places[i];
    if (place.isLeaf()) continue;
    const auto [a, b] = place.daughter;
    place.leaves = (a < 0 ? 0 : places[a].leaves) + (b < 0 ? 0 : places[b].leaves);
    place.x = a < 0 ? places[b].x : b < 0 ? places[a].x : 0.5 * (places[a].x + places[b].x);
  }
  return layout;
}

}  // namespace morula
