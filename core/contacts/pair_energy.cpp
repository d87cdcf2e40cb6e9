#include "contacts/pair_energy.h"

#include <algorithm>
#include <tuple>

namespace morula {
namespace {

struct Point6 {
  Point y;
  Vector n;
  double curvature;
};

Point6 read(const Contacts& c, const Bodies& b, VertexNumber g) {
  const SnapshotRow r = readRow(c.rows[g], b.parameters.precision);
  return {{r.x, r.y, r.z}, {r.nx, r.ny, r.nz}, r.inverseRadiusSquared};
}

/// T [energy] of a pair, T_eff, and T for W = 1.
struct Attraction {
  double strength = 0, effective = 0, perWork = 0;
};

/// Adds a pair. Adds its share of 6 a ρ to `density`.
void add(const Point6& i, const Point6& j, double stiffness, const Attraction& attraction, PairSum& sum,
         double& density) {
  const Vector a = i.y - j.y, h = 0.5 * (j.n - i.n);
  const double curvature = 0.5 * (i.curvature + j.curvature), nearness = curvature * dot(a, a);
  const double perReach = 1 / (attractionReach * attractionReach), w = std::max(1 - perReach * nearness, 0.0);
  const bool near = nearness < 1;
  if (!near && !(attraction.perWork != 0 && w > 0)) return;
  const double u = near ? (1 - nearness) * (1 + nearness) : 0;
  const double m = 1 - dot(i.n, j.n), t = std::min(m / minFacing, 1.0), s = t * t * (3 - 2 * t);
  const double z = 0.25 * m * m * (3 - m), held = attraction.effective * w * w;
  const double depth = near ? std::max(0.0, -dot(a, h)) : 0.0, b = curvature * depth * depth * u;
  const double barrier = stiffness * depth * depth, hardened = 1 + b * (hardening1 + hardening2 * b);
  const double byDepth = s * stiffness * depth * u * u * (1 + b * (2 * hardening1 + 3 * hardening2 * b));
  const double byFade =
      nearness * s * barrier * u * (2 + b * (3 * hardening1 + 4 * hardening2 * b)) - 0.5 * perReach * z * held;
  const Vector f = byDepth * h + (2 * curvature * byFade) * a;
  sum.repulsion += 0.25 * s * barrier * u * u * hardened;
  sum.held += z * attraction.strength * (w * w * w) / 12;
  density += z * attraction.perWork * (w * w * w);
  sum.deepest = std::max(sum.deepest, b);
  sum.force += f;
  if (depth > 0 && dot(h, h) > 0) sum.pressing += std::max(0.0, dot(f, h) / norm(h));
}

Attraction attractionOf(const Contacts& c, int block, std::size_t at, VertexNumber i, VertexNumber j) {
  if (!c.parameters.adhesion) return {};
  const double *ofI = &c.adhesion.saturation[2 * std::size_t(i)], *ofJ = &c.adhesion.saturation[2 * std::size_t(j)];
  const double strength = c.adhesion.ofPairs[block][at], perWork = c.adhesion.perWork[block][at];
  return {strength, strength * (ofI[0] + ofJ[0]) + perWork * (ofI[1] + ofJ[1]), perWork};
}

}  // namespace

std::vector<PairSum> sumPairs(const Contacts& c, const Bodies& b) {
  std::vector<int> slotOfLine(b.lineCount());  // [line] first slot of the line's block
  for (int block = 0; block < b.blockCount(); ++block)
    std::fill_n(slotOfLine.begin() + b.blocks[block].firstLine, b.verticesPerLane(block), block * blockLanes);
  const auto slotOf = [&](VertexNumber g) { return slotOfLine[g / blockLanes] + g % blockLanes; };
  const auto far = static_cast<VertexNumber>(c.rows.size() - 1);
  std::vector<PairSum> sums;
  std::vector<PairSum> own;  // of one vertex
  for (int block = 0; block < b.blockCount(); ++block)
    for (const NeighbourSlice& slice : c.list.perBlock[block].slices)
      for (int lane = 0; lane < blockLanes; ++lane) {
        const VertexNumber g = slice.vertex[lane];
        if (g == far) continue;
        const Point6 i = read(c, b, g);
        double density = 0;
        own.clear();
        for (int k = 0; k < slice.length; ++k) {
          const std::size_t at = (slice.start + k) * blockLanes + lane;
          const VertexNumber j = c.list.perBlock[block].indices[at];
          if (j == far) break;
          const int other = slotOf(j);
          auto sum = std::find_if(own.begin(), own.end(), [&](const PairSum& p) { return p.other == other; });
          if (sum == own.end())
            sum = own.insert(own.end(), {.vertex = g, .slot = slotOf(g), .other = other, .force = {}});
          add(i, read(c, b, j), c.parameters.stiffness, attractionOf(c, block, at, g, j), *sum, density);
        }
        if (density > 0) {
          const double saturation = saturationAt(density / (6 * restAreaOfVertex(c, b, slotOf(g))));
          for (PairSum& sum : own) sum.adhesion = -saturation * sum.held;
        }
        sums.insert(sums.end(), own.begin(), own.end());
      }
  // Callers' sums have one order, whatever the order of the slices, which depends on when the list was built.
  std::vector<int> cellOf(b.blocks.size() * blockLanes);
  for (int cell = 0; cell < b.count; ++cell) cellOf[b.slots[cell]] = cell;
  const auto key = [&](const PairSum& p) {
    const auto [first, second] = std::minmax(cellOf[p.slot], cellOf[p.other]);
    return std::tuple(first, second, p.vertex);
  };
  std::sort(sums.begin(), sums.end(), [&](const PairSum& p, const PairSum& q) { return key(p) < key(q); });
  return sums;
}

}  // namespace morula
