#include "contacts/aabb_tree.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace morula {
namespace {

constexpr int leafSize = 12;  // the fastest of 4 … 21 for packed cells of 162 vertices

Box around(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y), std::min(a.low.z, b.low.z)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y), std::max(a.high.z, b.high.z)}};
}

/// Refits boxes from the leaves up: children stand behind their parents.
void refit(TreeSearch& tree, const SearchInput& input, int slot) {
  const Bodies& bodies = input.bodies;
  const auto& [meshLevel, firstBox, base] = tree.trees[slot];
  const TreeShape& shape = tree.shapes[meshLevel];
  const int vertices = bodies.vertexCount(slot);
  const VertexNumber firstNumber = bodies.blocks[slot / blockLanes].firstLine * blockLanes + slot % blockLanes;
  for (int i = 0; i < vertices; ++i) {
    const int v = shape.order[i];
    tree.points.set(base + i, input.vertex(slot, v), firstNumber + v * blockLanes, slot, input.halfReach[slot]);
  }
  Box* boxes = &tree.boxes[firstBox];
  for (std::size_t n = shape.nodes.size(); n-- > 0;) {
    const TreeNode& node = shape.nodes[n];
    if (node.leaf < 0) {
      boxes[n] = around(boxes[n + 1], boxes[node.second]);
      continue;
    }
    // A NaN compares with nothing, so that it is left out.
    Box box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (std::int32_t i = base + node.first; i < base + node.last; ++i) {
      const Point x{tree.points.x[i], tree.points.y[i], tree.points.z[i]};
      box = around(box, {x, x});
    }
    boxes[n] = box;
  }
}

/// Returns the square of the distance of two boxes. It rounds as the square of the distance of two points does,
/// operation by operation, so it never exceeds that of any two points in the boxes.
double distanceSquared(const Box& a, const Box& b) {
  const auto gap = [](double lowA, double highA, double lowB, double highB) {
    return std::max(0.0, std::max(lowB - highA, lowA - highB));
  };
  const Vector d{gap(a.low.x, a.high.x, b.low.x, b.high.x), gap(a.low.y, a.high.y, b.low.y, b.high.y),
                 gap(a.low.z, a.high.z, b.low.z, b.high.z)};
  return dot(d, d);
}

/// Goes down both trees at once, the one with more vertices first, and notes which leaves of `other` are near
/// which leaves of `own`.
void descend(const TreeSearch& tree, TreeSearch::Scratch& scratch, const CellTree& own, const CellTree& other,
             double reachSquared, SearchCounters& counters) {
  const std::vector<TreeNode>&ownNodes = tree.shapes[own.meshLevel].nodes,
        &otherNodes = tree.shapes[other.meshLevel].nodes;
  const Box *ownBoxes = &tree.boxes[own.firstBox], *otherBoxes = &tree.boxes[other.firstBox];
  auto& open = scratch.open;
  open.clear();
  open.push_back({0, 0});
  ++counters.rootTests;
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    ++counters.boxTests;
    if (!(distanceSquared(ownBoxes[a], otherBoxes[b]) < reachSquared)) continue;
    const TreeNode &p = ownNodes[a], &q = otherNodes[b];
    if (p.leaf >= 0 && q.leaf >= 0) {
      scratch.rows[p.leaf].push_back({other.firstPoint + q.first, other.firstPoint + q.last});
    } else if (q.leaf >= 0 || (p.leaf < 0 && p.last - p.first >= q.last - q.first)) {
      open.push_back({p.second, b});
      open.push_back({a + 1, b});
    } else {
      open.push_back({a, q.second});
      open.push_back({a, b + 1});
    }
  }
}

/// Returns the shape of a mesh's trees; makes it when a cell first has the mesh.
const TreeShape& shapeAt(TreeSearch& tree, const Bodies& bodies, int meshLevel) {
  if (static_cast<int>(tree.shapes.size()) <= meshLevel) tree.shapes.resize(meshLevel + 1);
  TreeShape& shape = tree.shapes[meshLevel];
  const std::vector<Point>& vertices = bodies.meshAt(meshLevel).mesh.vertices;
  if (shape.order.size() != vertices.size()) {
    shape = makeTreeShape(vertices, leafSize);
    ++tree.preparation.treesBuilt;
  }
  return shape;
}

struct Builder {
  const std::vector<Point>& vertices;
  int leafSize;
  TreeShape shape;

  double coordinate(std::int32_t v, int axis) const {
    const Point& x = vertices[v];
    return axis == 0 ? x.x : axis == 1 ? x.y : x.z;
  }

  int longestAxis(std::int32_t first, std::int32_t last) const {
    double longest = -1;
    int axis = 0;
    for (int a = 0; a < 3; ++a) {
      double low = coordinate(shape.order[first], a), high = low;
      for (std::int32_t i = first; i < last; ++i) {
        low = std::min(low, coordinate(shape.order[i], a));
        high = std::max(high, coordinate(shape.order[i], a));
      }
      if (high - low > longest) longest = high - low, axis = a;
    }
    return axis;
  }

  void add(std::int32_t first, std::int32_t last) {
    const std::size_t self = shape.nodes.size();
    if (last - first <= leafSize) {
      shape.nodes.push_back({first, last, 0, shape.leaves++});
      return;
    }
    shape.nodes.push_back({first, last, 0, -1});
    const int axis = longestAxis(first, last);
    std::sort(shape.order.begin() + first, shape.order.begin() + last, [&](std::int32_t a, std::int32_t b) {
      const double p = coordinate(a, axis), q = coordinate(b, axis);
      return p != q ? p < q : a < b;
    });
    const std::int32_t middle = first + (last - first) / 2;
    add(first, middle);
    shape.nodes[self].second = static_cast<std::int32_t>(shape.nodes.size());
    add(middle, last);
  }
};

}  // namespace

void prepare(TreeSearch& tree, const SearchInput& input, int threads) {
  const Bodies& bodies = input.bodies;
  tree.preparation = {};
  tree.trees.resize(bodies.blocks.size() * blockLanes);
  tree.scratch.resize(threads);
  std::size_t boxes = 0, points = 0;
  int leaves = 0;
  for (int slot : bodies.slots) {
    const int meshLevel = bodies.blocks[slot / blockLanes].meshLevel;
    const TreeShape& shape = shapeAt(tree, bodies, meshLevel);
    tree.trees[slot] = {meshLevel, static_cast<std::int32_t>(boxes), static_cast<std::int32_t>(points)};
    leaves = std::max(leaves, shape.leaves);
    boxes += shape.nodes.size();
    points += shape.order.size();
  }
  for (auto& s : tree.scratch) s.rows.resize(leaves);
  tree.boxes.resize(boxes);
  tree.points.resize(static_cast<int>(points));
  parallelFor(bodies.count, threads, [&](int cell) { refit(tree, input, bodies.slots[cell]); });
  tree.preparation.boxesRefitted = tree.boxes.size();
}

void searchBlock(const TreeSearch& tree, const SearchInput& input, int block, BlockLists& lists) {
  const Bodies& bodies = input.bodies;
  TreeSearch::Scratch& scratch = tree.scratch[threadNumber()];
  for (int lane = 0; lane < bodies.liveLanes(block); ++lane) {
    const int slot = block * blockLanes + lane;
    const CellTree& own = tree.trees[slot];
    const TreeShape& shape = tree.shapes[own.meshLevel];
    for (auto& rows : scratch.rows) rows.clear();
    for (int other : bodies.slots) {
      const double reach = input.reach(slot, other);
      if (other != slot) descend(tree, scratch, own, tree.trees[other], reach * reach, lists.counters);
    }
    for (const TreeNode& node : shape.nodes)
      for (std::int32_t i = node.first; node.leaf >= 0 && i < node.last; ++i) {
        const auto& rows = scratch.rows[node.leaf];
        const int v = shape.order[i];
        findNeighbours(lists, input, tree.points, rows.data(), static_cast<int>(rows.size()), slot,
                       v * blockLanes + lane, input.vertex(slot, v));
      }
  }
}

TreeShape makeTreeShape(const std::vector<Point>& vertices, int leafSize) {
  Builder builder{vertices, leafSize, {}};
  const auto count = static_cast<std::int32_t>(vertices.size());
  for (std::int32_t v = 0; v < count; ++v) builder.shape.order.push_back(v);
  builder.add(0, count);
  return builder.shape;
}

}  // namespace morula
