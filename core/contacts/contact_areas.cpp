// Who touches whom, and over which area. For measures and decisions, once in a while: not on the hot path.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "contacts/contacts.h"

namespace morula {

namespace {

SnapshotRow rowOf(const Contacts& c, VertexNumber g) {
  SnapshotRow row;
  std::memcpy(&row, &c.rows[std::size_t(g) * 8], sizeof row);
  return row;
}

/// What one vertex adds to the area of a pair of cells.
struct Side {
  ContactArea pair;
  VertexNumber vertex;
};

/// A third of the area of the faces around each vertex of a cell. [length²]
std::vector<double> vertexAreas(const Bodies& b, int slot) {
  std::vector<double> areas(b.vertexCount(), 0);
  for (const Face& f : b.mesh.mesh.faces) {
    const Point p = b.vertex(slot, f[0]);
    const double sixth = norm(cross(b.vertex(slot, f[1]) - p, b.vertex(slot, f[2]) - p)) / 6;
    for (int v : f) areas[v] += sixth;
  }
  return areas;
}

/// The slot that vertex g touches, or −1.
int touchedSlot(const Contacts& c, const Bodies& b, const NeighbourSlice& slice, int lane) {
  const SnapshotRow i = rowOf(c, slice.vertex[lane]);
  const VertexNumber far = static_cast<VertexNumber>(c.rows.size() / 8 - 1);
  double nearest = 1e300;
  int touched = -1;
  for (int k = 0; k < slice.length; ++k) {
    const VertexNumber g = c.list.indices[(slice.start + k) * blockLanes + lane];
    if (g == far) break;
    const SnapshotRow j = rowOf(c, g);
    const Vector apart{i.x - j.x, i.y - j.y, i.z - j.z};
    const double square = dot(apart, apart);
    const double radiusSquared = 2 / (double(i.inverseRadiusSquared) + double(j.inverseRadiusSquared));
    if (square >= radiusSquared || square >= nearest) continue;
    const Vector ni{i.nx, i.ny, i.nz}, nj{j.nx, j.ny, j.nz}, facing = nj - ni;
    if (dot(ni, nj) >= 0 || dot(apart, facing) > 0.25 * std::sqrt(radiusSquared) * norm(facing)) continue;
    nearest = square;
    touched = g / (blockLanes * b.vertexCount()) * blockLanes + g % blockLanes;
  }
  return touched;
}

}  // namespace

std::vector<ContactArea> measureContactAreas(const Contacts& c, const Bodies& b) {
  std::vector<Side> sides;  // the same pair may occur many times
  const VertexNumber far = static_cast<VertexNumber>(c.rows.size() / 8 - 1);
  std::vector<std::vector<double>> areas;
  for (int slot = 0; slot < b.count; ++slot) areas.push_back(vertexAreas(b, slot));
  for (const NeighbourSlice& slice : c.list.slices)
    for (int lane = 0; lane < blockLanes; ++lane) {
      const VertexNumber g = slice.vertex[lane];
      if (g == far) continue;
      const int other = touchedSlot(c, b, slice, lane);
      if (other < 0) continue;
      const int line = g / blockLanes, own = line / b.vertexCount() * blockLanes + g % blockLanes;
      sides.push_back(
          {{std::min(own, other), std::max(own, other), 0.5 * areas[own][line % b.vertexCount()]}, g});
    }
  // One order for the sums, whatever the order of the slices, which hangs on when the list was built.
  std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
    return std::tie(p.pair.a, p.pair.b, p.vertex) < std::tie(q.pair.a, q.pair.b, q.vertex);
  });
  std::vector<ContactArea> pairs;
  for (const auto& [s, vertex] : sides) {
    if (pairs.empty() || pairs.back().a != s.a || pairs.back().b != s.b) pairs.push_back({s.a, s.b, 0});
    pairs.back().area += s.area;
  }
  return pairs;
}

}  // namespace morula
