// Who touches whom, and over which area. For measures and decisions, once in a while: not on the hot path.
#include <algorithm>
#include <cstring>

#include "contacts/contacts.h"

namespace morula {

namespace {

SnapshotRow rowOf(const Contacts& c, VertexNumber g) {
  SnapshotRow row;
  std::memcpy(&row, &c.rows[std::size_t(g) * 8], sizeof row);
  return row;
}

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
    const double radius = 0.5 * (double(i.radius) + double(j.radius)), square = dot(apart, apart);
    if (square >= radius * radius || square >= nearest) continue;
    const Vector ni{i.nx, i.ny, i.nz}, nj{j.nx, j.ny, j.nz}, facing = nj - ni;
    if (dot(ni, nj) >= 0 || dot(apart, facing) > 0.25 * radius * norm(facing)) continue;
    nearest = square;
    touched = g / (blockLanes * b.vertexCount()) * blockLanes + g % blockLanes;
  }
  return touched;
}

}  // namespace

std::vector<ContactArea> measureContactAreas(const Contacts& c, const Bodies& b) {
  std::vector<ContactArea> sides;  // each vertex's share; the same pair may occur many times
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
      sides.push_back({std::min(own, other), std::max(own, other), 0.5 * areas[own][line % b.vertexCount()]});
    }
  // One order for the sums: slices of equal length are ordered by number already, so a stable sort keeps it.
  std::stable_sort(sides.begin(), sides.end(), [](const ContactArea& p, const ContactArea& q) {
    return p.a != q.a ? p.a < q.a : p.b < q.b;
  });
  std::vector<ContactArea> pairs;
  for (const ContactArea& s : sides) {
    if (pairs.empty() || pairs.back().a != s.a || pairs.back().b != s.b) pairs.push_back({s.a, s.b, 0});
    pairs.back().area += s.area;
  }
  return pairs;
}

}  // namespace morula
