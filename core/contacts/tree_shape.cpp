#include <algorithm>

#include "contacts/aabb_tree.h"

namespace morula {
namespace {

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

TreeShape makeTreeShape(const std::vector<Point>& vertices, int leafSize) {
  Builder builder{vertices, leafSize, {}};
  const auto count = static_cast<std::int32_t>(vertices.size());
  for (std::int32_t v = 0; v < count; ++v) builder.shape.order.push_back(v);
  builder.add(0, count);
  return builder.shape;
}

}  // namespace morula
