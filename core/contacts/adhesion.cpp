#include "contacts/adhesion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "contacts/contacts.h"

namespace morula {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns the area of a vertex at rest over the square of its influence radius [1].
double areaOverSquare(const MeshTemplate& mesh, double influence) {
  double area = 0;
  for (const auto& [i, j, k] : mesh.mesh.faces) {
    const Point& p = mesh.mesh.vertices[i];
    area += 0.5 * norm(cross(mesh.mesh.vertices[j] - p, mesh.mesh.vertices[k] - p));
  }
  const double radius = influence * mesh.meanRestLength;
  return area / (mesh.vertexCount() * radius * radius);
}

/// Returns the length [1] of a normal in a flat mesh, whose G is six times a vertex's area (surface_kernel.h).
double normalLength(double areaOverSquare) {
  const double g = 6 * areaOverSquare;
  return g * std::sqrt(normalScaleSquared / (g * g + foldedNormal * foldedNormal));
}

/// Returns T of vertices of these two slots for W = 1; for spheres a force. Exchanging the slots changes no bit.
double pairFactor(const Contacts& c, const Bodies& b, int i, int j) {
  const double ri = c.radius[i], rj = c.radius[j];
  if (b.areSpheres()) return pi * (ri * rj) / (ri + rj);  // their influence radius is the diameter
  const auto normalOf = [&](int slot) {
    return normalLength(c.adhesion.areaOverSquare[b.blocks[slot / blockLanes].meshLevel]);
  };
  const double m = 1 + normalOf(i) * normalOf(j), s = 0.25 * m * m * (3 - m);
  return 24 / pi * (restAreaOfVertex(c, b, i) * restAreaOfVertex(c, b, j)) * inverseReachSquared(c, i, j) / s;
}

void fillBlock(Contacts& c, const Bodies& b, int block, VertexNumber far) {
  const auto slotOf = [&](VertexNumber g) {
    return c.adhesion.blockOfLine[g / blockLanes] * blockLanes + g % blockLanes;
  };
  const BlockLists& lists = c.list.perBlock[block];
  AlignedVector<double>& ofPairs = c.adhesion.ofPairs[block];
  ofPairs.resize(lists.indices.size());
  const bool saturates = !b.areSpheres();
  AlignedVector<double>& perWork = c.adhesion.perWork[block];
  if (saturates) perWork.resize(lists.indices.size());
  for (const NeighbourSlice& slice : lists.slices) {
    for (int lane = 0; lane < blockLanes; ++lane) {
      const int own = block * blockLanes + slice.vertex[lane] % blockLanes;
      int other = -1;  // neighbours are mostly of one cell
      double strength = 0, factor = 0;
      for (int k = 0; k < slice.length; ++k) {
        const std::int64_t at = (slice.start + k) * blockLanes + lane;
        const VertexNumber g = lists.indices[at];
        if (g != far && slotOf(g) != other) {
          other = slotOf(g);
          factor = pairFactor(c, b, own, other);
          strength = workOfAdhesion(c, own, other) * factor;
        }
        ofPairs[at] = g == far ? 0 : strength;
        if (saturates) perWork[at] = g == far ? 0 : factor;
      }
    }
  }
}

}  // namespace

double workOfAdhesion(const Contacts& c, int i, int j) {
  const AdhesionKinds& k = c.adhesion.kinds;
  const double work = k.work.empty() ? c.parameters.adhesion->strength : k.work[k.ofSlot[i] * k.count + k.ofSlot[j]];
  return k.factor.empty() ? work : work * (0.5 * (k.factor[i] + k.factor[j]));
}

double restAreaOfVertex(const Contacts& c, const Bodies& b, int slot) {
  const double r = c.radius[slot];
  return c.adhesion.areaOverSquare[b.blocks[slot / blockLanes].meshLevel] * (r * r);
}

double inverseReachSquared(const Contacts& c, int i, int j) {
  const double ri = c.radius[i], rj = c.radius[j];
  return 0.5 * (1 / (ri * ri) + 1 / (rj * rj)) / (attractionReach * attractionReach);
}

void resetAdhesion(Contacts& c, const Bodies& b) {
  if (!c.parameters.adhesion) return;
  Adhesion& a = c.adhesion;
  a.blockOfLine.resize(b.lineCount());
  for (int block = 0; block < b.blockCount(); ++block)
    std::fill_n(a.blockOfLine.begin() + b.blocks[block].firstLine, b.verticesPerLane(block), block);
  a.areaOverSquare.clear();
  for (int level = 0; !b.areSpheres() && level <= static_cast<int>(b.coarser.size()); ++level)
    a.areaOverSquare.push_back(areaOverSquare(b.meshAt(level), c.parameters.radius));
  setAdhesionKinds(c, {});
}

void setAdhesionKinds(Contacts& c, AdhesionKinds kinds) {
  c.adhesion.kinds = std::move(kinds);
  c.adhesion.isCurrent = false;
}

void findPairStrengths(Contacts& c, const Bodies& b, int threads) {
  c.adhesion.ofPairs.resize(b.blockCount());
  c.adhesion.perWork.resize(b.blockCount());
  const VertexNumber far = b.lineCount() * blockLanes;
  parallelFor(b.blockCount(), threads, [&](int block) { fillBlock(c, b, block, far); });
  c.adhesion.isCurrent = true;
}

double saturationAt(double density) {
  if (density <= 1) return 1;
  const double left = 1 - std::min((density - 1) / (3 * (maxHeld - 1)), 1.0);
  return (maxHeld - (maxHeld - 1) * (left * left * left)) / density;
}

void findCrowding(Contacts& c, const Bodies& b, int threads) {
  if (!c.parameters.adhesion || b.areSpheres()) return;
  c.adhesion.saturation.assign(2 * c.rows.size(), 0);
  parallelFor(b.blockCount(), threads, [&](int block) {
    const BlockLists& lists = c.list.perBlock[block];
    BlockSlices slices{};
    slices.slices = lists.slices.data(), slices.count = std::ssize(lists.slices);
    ContactConstants constants{};
    constants.vertices = b.lineCount() * blockLanes;
    constants.adhesion = c.adhesion.ofPairs[block].data(), constants.adhesionPerWork = c.adhesion.perWork[block].data();
    double areas[blockLanes];
    for (int lane = 0; lane < blockLanes; ++lane)  // any area will do for lanes without a cell, which have no pairs
      areas[lane] = lane < b.liveLanes(block) ? restAreaOfVertex(c, b, block * blockLanes + lane) : 1;
    c.kernels->findCrowding(slices, lists.indices.data(), c.rows.data(), constants, areas,
                            c.adhesion.saturation.data());
  });
}

double adhesionStiffness(const Contacts& c, const Bodies& b) {
  if (!c.parameters.adhesion || b.count == 0) return 0;
  double work = c.parameters.adhesion->strength;
  for (const AdhesionPair& pair : c.parameters.adhesion->pairs) work = std::max(work, pair.strength);
  const auto& factor = c.adhesion.kinds.factor;
  if (!factor.empty()) work *= *std::max_element(factor.begin(), factor.end());
  // For spheres S/δ is at most 4πW, and (1 − u²)² at its steepest 1.54.
  if (b.areSpheres()) return 1.54 * 4 * pi * work;
  // The pair with the most different radii has the largest factor.
  const auto smaller = [&](int i, int j) { return c.radius[i] < c.radius[j]; };
  const auto [least, most] = std::minmax_element(b.slots.begin(), b.slots.end(), smaller);
  const auto steepest = [&](int i, int j) {
    return pairFactor(c, b, i, j) * inverseReachSquared(c, i, j) * (attractionReach * attractionReach);
  };
  return work * std::max({steepest(*least, *most), steepest(*least, *least), steepest(*most, *most)});
}

}  // namespace morula
