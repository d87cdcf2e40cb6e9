// Finds the cells that touch and the areas of their contacts. Measures and decisions need them now and then, not each
// step.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "contacts/contacts.h"
#include "contacts/pair_energy.h"

namespace morula {
namespace {

/// The share of one vertex in the contact area of a pair of cells.
struct Side {
  ContactArea pair;
  VertexNumber vertex;
};

/// Returns a third of the area [length²] of the faces around each vertex of a cell.
std::vector<double> vertexAreas(const Bodies& b, int slot) {
  std::vector<double> areas(b.vertexCount(slot), 0);
  for (const Face& f : b.meshOf(slot).mesh.faces) {
    const Point p = b.vertex(slot, f[0]);
    const double sixth = norm(cross(b.vertex(slot, f[1]) - p, b.vertex(slot, f[2]) - p)) / 6;
    for (int v : f) areas[v] += sixth;
  }
  return areas;
}

/// The place of vertex g: its line within its cell, and its slot.
struct VertexPlace {
  int vertex, slot;
};

VertexPlace placeOf(const Bodies& b, VertexNumber g) {
  const int line = g / blockLanes;
  const auto after = std::upper_bound(b.blocks.begin(), b.blocks.end(), line,
                                      [](int l, const BlockPlace& block) { return l < block.firstLine; });
  const int block = static_cast<int>(after - b.blocks.begin()) - 1;
  return {line - b.blocks[block].firstLine, block * blockLanes + g % blockLanes};
}

/// Returns the number of each slot's cell.
std::vector<int> cellsOf(const Bodies& b) {
  std::vector<int> cells(b.blocks.size() * blockLanes);
  for (int cell = 0; cell < b.count; ++cell) cells[b.slots[cell]] = cell;
  return cells;
}

/// Returns the slot that vertex g touches, or −1.
int touchedSlot(const Contacts& c, const Bodies& b, const BlockLists& lists, const NeighbourSlice& slice, int lane) {
  const SnapshotRow i = readRow(c.rows[slice.vertex[lane]], b.parameters.precision);
  const VertexNumber far = static_cast<VertexNumber>(c.rows.size() - 1);
  double nearest = 1e300;
  int touched = -1;
  for (int k = 0; k < slice.length; ++k) {
    const VertexNumber g = lists.indices[(slice.start + k) * blockLanes + lane];
    if (g == far) break;
    const SnapshotRow j = readRow(c.rows[g], b.parameters.precision);
    const Vector apart{i.x - j.x, i.y - j.y, i.z - j.z};
    const double square = dot(apart, apart);
    const double radiusSquared = 2 / (double(i.inverseRadiusSquared) + double(j.inverseRadiusSquared));
    if (square >= radiusSquared || square >= nearest) continue;
    const Vector ni{i.nx, i.ny, i.nz}, nj{j.nx, j.ny, j.nz}, facing = nj - ni;
    if (dot(ni, nj) >= 0 || dot(apart, facing) > 0.25 * std::sqrt(radiusSquared) * norm(facing)) continue;
    nearest = square;
    touched = placeOf(b, g).slot;
  }
  return touched;
}

/// Returns the area [length²] of the disc in which the surfaces of two spheres meet; 0 if they do not meet.
double discArea(const SnapshotRow& i, double ri, const SnapshotRow& j, double rj) {
  const Vector apart{i.x - j.x, i.y - j.y, i.z - j.z};
  const double square = dot(apart, apart), distance = std::sqrt(square);
  if (!(distance > 0 && distance < ri + rj)) return 0;
  const double along = (square + ri * ri - rj * rj) / (2 * distance);  // from i to the disc's plane
  return std::numbers::pi * std::max(ri * ri - along * along, 0.0);    // 0: one is inside the other
}

std::vector<ContactArea> sphereContacts(const Contacts& c, const Bodies& b) {
  std::vector<ContactArea> pairs;
  const VertexNumber far = static_cast<VertexNumber>(c.rows.size() - 1);
  const std::vector<int> cellOf = cellsOf(b);
  for (const BlockLists& lists : c.list.perBlock)
    for (const NeighbourSlice& slice : lists.slices)
      for (int lane = 0; lane < blockLanes; ++lane)
        for (int k = 0; slice.vertex[lane] != far && k < slice.length; ++k) {
          const VertexNumber g = slice.vertex[lane], h = lists.indices[(slice.start + k) * blockLanes + lane];
          if (h == far) break;
          if (h < g) continue;  // each pair stands in both lists
          const int slotG = placeOf(b, g).slot, slotH = placeOf(b, h).slot;
          const double area = discArea(readRow(c.rows[g], b.parameters.precision), 0.5 * c.radius[slotG],
                                       readRow(c.rows[h], b.parameters.precision), 0.5 * c.radius[slotH]);
          const auto [first, second] = std::minmax(cellOf[slotG], cellOf[slotH]);
          if (area > 0) pairs.push_back({first, second, area});
        }
  std::sort(pairs.begin(), pairs.end(),
            [](const ContactArea& p, const ContactArea& q) { return std::tie(p.a, p.b) < std::tie(q.a, q.b); });
  return pairs;
}

constexpr double minOverlap = 1.0 / 5000;  // min overlap over the influence radius
constexpr double maxCover = 2;             // max, over a vertex's area and the area that forces give a sticking pair
// [1] minHeld and stressOverWork bring areas of two cells on icospheres 2 to 4 nearest to those on icosphere 5, for W
// from 0.1 to 2, free or pressed together.
constexpr double minHeld = 0.1;       // share of W below which a vertex covers nothing
constexpr double stressOverWork = 3;  // σ A/W
// A share of the smaller cell's surface as a sphere. Smaller areas come from one or two vertices and depend on the
// meshes' orientation.
constexpr double minShare = 0.005;

/// Returns c of one vertex. Surfaces that touch, with n vertices per area of rest area a each, hold −W (a n)² per area
/// of both sides.
double coverOf(const PairSum& p, double work, double own, double atRest) {
  const double held = 2 * p.held * own / (work * atRest * atRest);
  return std::clamp((held - minHeld) / (1 - minHeld), 0.0, 1.0);
}

/// Returns areas by pressure: the force on the vertices of either side over the mean pressure in both cells, or over
/// the pressure that the overlap bears where that is larger. No vertex counts for more than twice its area. For cells
/// that stick, contact_areas.h gives the formula.
std::vector<ContactArea> pressedAreas(const Contacts& c, const Bodies& b) {
  std::vector<std::vector<double>> areas(b.blocks.size() * blockLanes);  // [slot][vertex]
  for (int slot : b.slots) areas[slot] = vertexAreas(b, slot);
  const std::vector<int> cellOf = cellsOf(b);
  const auto pressureOf = [&](int slot) { return b.model().hasMembrane ? b.pressure[slot] : 0.0; };
  std::vector<ContactArea> pairs;
  std::vector<double> pressed;  // [pair] by forces alone
  for (const PairSum& p : sumPairs(c, b)) {
    if (!(p.pressing > 0) && !(p.adhesion < 0)) continue;
    const double own = areas[p.slot][placeOf(b, p.vertex).vertex];
    const double least = c.parameters.stiffness * minOverlap * c.radius[p.slot] / own;
    const double pressure = std::max(0.5 * (pressureOf(p.slot) + pressureOf(p.other)), least);
    const double byForce = std::min(p.pressing / pressure, maxCover * own);
    const auto [first, second] = std::minmax(cellOf[p.slot], cellOf[p.other]);
    if (pairs.empty() || pairs.back().a != first || pairs.back().b != second)
      pairs.push_back({first, second, 0}), pressed.push_back(0);
    double area = byForce;
    if (p.adhesion < 0) {
      const double work = workOfAdhesion(c, p.slot, p.other);
      const double share = stressOverWork * work * std::sqrt(inverseReachSquared(c, p.slot, p.other)) / pressure;
      area = (byForce + share * own * coverOf(p, work, own, restAreaOfVertex(c, b, p.slot))) / (1 + share);
    }
    pairs.back().area += 0.5 * area;
    pressed.back() += 0.5 * byForce;
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].area = std::min(pairs[k].area, maxCover * pressed[k]);
  std::erase_if(pairs, [&](const ContactArea& p) {
    const double radius = b.parameters.cell.radius * std::min(b.restScale[b.slots[p.a]], b.restScale[b.slots[p.b]]);
    return p.area < minShare * 4 * std::numbers::pi * radius * radius;
  });
  return pairs;
}

}  // namespace

std::vector<ContactArea> measureContactAreas(const Contacts& c, const Bodies& b) {
  if (b.areSpheres()) return sphereContacts(c, b);
  if (c.parameters.law == ContactLaw::pair) return pressedAreas(c, b);
  std::vector<Side> sides;  // a pair may occur many times
  const VertexNumber far = static_cast<VertexNumber>(c.rows.size() - 1);
  std::vector<std::vector<double>> areas;  // [cell][vertex]
  for (int slot : b.slots) areas.push_back(vertexAreas(b, slot));
  const std::vector<int> cellOf = cellsOf(b);
  for (const BlockLists& lists : c.list.perBlock)
    for (const NeighbourSlice& slice : lists.slices)
      for (int lane = 0; lane < blockLanes; ++lane) {
        const VertexNumber g = slice.vertex[lane];
        if (g == far) continue;
        const int touched = touchedSlot(c, b, lists, slice, lane);
        if (touched < 0) continue;
        const VertexPlace place = placeOf(b, g);
        const int own = cellOf[place.slot], other = cellOf[touched];
        sides.push_back({{std::min(own, other), std::max(own, other), 0.5 * areas[own][place.vertex]}, g});
      }
  // The sums have one order, whatever the order of the slices, which depends on when the list was built.
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
