
#include "observation/sanity.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "contacts/contact_surface.h"
#include "contacts/pair_energy.h"
#include "mesh/mesh_measures.h"
#include "mesh/overlap.h"
#include "observation/body_measures.h"
#include "observation/crumpling.h"
#include "observation/measures.h"
#include "physics/shell_surface.h"
#include "state/world.h"

namespace morula {
namespace {

constexpr double ballVolume = 4 * std::numbers::pi / 3;  // over the cube of the radius
constexpr int linesPerPair = 16;

/// The worst value so far and its cell. NaN is the worst value there can be, and stays it.
struct Worst {
  double value;
  int cell = -1, other = -1;

  void raise(double v, int of, int with = -1) {
    if (cell >= 0 && !(v > value) && !std::isnan(v)) return;
    if (!std::isnan(value)) *this = {v, of, with};
  }
  void lower(double v, int of) {
    if (cell >= 0 && !(v < value) && !std::isnan(v)) return;
    if (!std::isnan(value)) *this = {v, of};
  }
};

SanityMeasure measureOf(const World& world, SanityKind kind, const Worst& worst, double least, double most) {
  SanityMeasure m{kind, worst.value, least, most, {}, {}};
  if (worst.cell >= 0) m.cell = world.cells.path[worst.cell];
  if (worst.other >= 0) m.other = world.cells.path[worst.other];
  return m;
}

bool isFinite(const Bodies& b, int slot) {
  double sum = b.volume[slot];
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    const Point x = b.vertex(slot, v), u = b.read(b.velocity, slot, v);
    sum += 0 * (x.x + x.y + x.z) + 0 * (u.x + u.y + u.z);  // 0 if finite, NaN otherwise
  }
  return std::isfinite(sum);
}

double boxVolume(const Box& a, const Box& b) {
  const double x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x),
               y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y),
               z = std::min(a.high.z, b.high.z) - std::max(a.low.z, b.low.z);
  return x > 0 && y > 0 && z > 0 ? x * y * z : 0;
}

/// Returns how much [length] of a line along `d` both surfaces cover.
double sharedLength(const Mesh& a, const Mesh& b, const Vector& d) {
  const auto range = [&d](const Mesh& m) {
    double low = INFINITY, high = -INFINITY;
    for (const Point& p : m.vertices) {
      const double along = dot(p, d);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    return std::pair{low, high};
  };
  const auto [aLow, aHigh] = range(a);
  const auto [bLow, bHigh] = range(b);
  return std::max(0.0, std::min(aHigh, bHigh) - std::max(aLow, bLow));
}

/// Returns a volume [length³] as boxVolume does, for boxes that stand along the way from one cell to the other:
/// neighbours that only touch share little of it, however they lie.
double turnedBoxVolume(const Mesh& a, const Mesh& b) {
  const Vector way = measureCentroid(b.vertices) - measureCentroid(a.vertices);
  if (!(norm(way) > 0)) return INFINITY;
  const Vector first = (1 / norm(way)) * way;
  const Vector aside = std::abs(first.x) < 0.6 ? Vector{1, 0, 0} : Vector{0, 1, 0};
  const Vector across = cross(first, aside), second = (1 / norm(across)) * across, third = cross(first, second);
  return sharedLength(a, b, first) * sharedLength(a, b, second) * sharedLength(a, b, third);
}

/// Returns the volume [length³] that two balls share: two caps, π (r + R − d)² (d² + 2d (r + R) − 3 (r − R)²)/(12 d).
double sharedBallVolume(double r, double R, double d) {
  const double smaller = std::min(r, R);
  if (d <= std::abs(r - R)) return ballVolume * smaller * smaller * smaller;
  const double depth = r + R - d;
  if (depth <= 0) return 0;
  return ballVolume / 16 * depth * depth * (d * d + 2 * d * (r + R) - 3 * (r - R) * (r - R)) / d;
}

/// Two cells that may share more than the bound.
struct Pair {
  double share;  // [1] max, of the smaller one's volume
  int smaller, larger;
};

/// Finds pairs by a sweep along x.
std::vector<Pair> findPairs(const std::vector<Mesh>& surfaces, const std::vector<double>& volumes) {
  const int count = static_cast<int>(surfaces.size());
  std::vector<Box> boxes;
  std::vector<int> order;
  for (int i = 0; i < count; ++i) {
    boxes.push_back(measureBox(surfaces[i].vertices));
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return boxes[a].low.x < boxes[b].low.x; });
  std::vector<Pair> pairs;
  for (int i = 0; i < count; ++i)
    for (int j = i + 1; j < count && boxes[order[j]].low.x < boxes[order[i]].high.x; ++j) {
      const int a = std::min(order[i], order[j]), b = std::max(order[i], order[j]);
      const int smaller = volumes[b] < volumes[a] ? b : a;
      double share = boxVolume(boxes[a], boxes[b]) / volumes[smaller];
      if (share > sanity::maxOverlap)
        share = std::min(share, turnedBoxVolume(surfaces[a], surfaces[b]) / volumes[smaller]);
      if (share > sanity::maxOverlap) pairs.push_back({share, smaller, a + b - smaller});
    }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.share > b.share; });
  return pairs;
}

double sharedVolume(const Bodies& b, const std::vector<Mesh>& surfaces, const Pair& pair) {
  if (!b.areSpheres())
    return measureSharedVolume({surfaces[pair.smaller].vertices, surfaces[pair.smaller].faces},
                               {surfaces[pair.larger].vertices, surfaces[pair.larger].faces}, linesPerPair);
  const int one = b.slots[pair.smaller], other = b.slots[pair.larger];
  const double radius = b.parameters.cell.radius;
  return sharedBallVolume(radius * b.restScale[one], radius * b.restScale[other],
                          norm(b.vertex(one, 0) - b.vertex(other, 0)));
}

Worst largestOverlap(const Bodies& b, const std::vector<Mesh>& surfaces) {
  std::vector<double> volumes;
  for (int slot : b.slots) volumes.push_back(b.volume[slot]);
  Worst worst{0};
  for (const Pair& pair : findPairs(surfaces, volumes)) {
    if (pair.share <= worst.value) break;  // no other pair can have more
    worst.raise(sharedVolume(b, surfaces, pair) / volumes[pair.smaller], pair.smaller, pair.larger);
    if (worst.value > sanity::maxOverlap) break;
  }
  return worst;
}

/// Returns the widest stretch along x, y or z without any cell's centre, in radii of the largest cell, and the cell at
/// its end on the side with fewer cells. A cell far from all others leaves a gap; a long chain of cells does not.
Worst widestGap(const std::vector<Point>& centres, double radius) {
  Worst worst{0};
  const int count = static_cast<int>(centres.size());
  std::vector<std::pair<double, int>> along(centres.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < count; ++i) {
      const Point& p = centres[i];
      along[i] = {axis == 0 ? p.x : axis == 1 ? p.y : p.z, i};
    }
    std::sort(along.begin(), along.end());
    for (int i = 1; i < count; ++i)
      worst.raise((along[i].first - along[i - 1].first) / radius, along[2 * i < count ? i - 1 : i].second);
  }
  return worst;
}

Worst maxBroken(const Bodies& b) {
  Worst broken{0};
  for (int cell = 0; cell < b.count; ++cell)
    if (!isFinite(b, b.slots[cell])) broken.raise(1, cell);
  return broken;
}

/// Adds the measures of surfaces; cells without a surface have none.
void addSurfaceMeasures(const World& world, const Observation& now, std::vector<SanityMeasure>& all) {
  if (world.bodies->areSpheres()) return;
  Worst folded{0}, selfOverlap{0};
  for (int i = 0; i < world.bodies->count; ++i) {
    const ObservedCell cell(now, i);  // holds the shape
    folded.raise(cell.foldedShare(), i);
    selfOverlap.raise(measureSelfOverlap(cell.physical()->getShape()), i);
  }
  all.push_back(measureOf(world, SanityKind::folded, folded, 0, sanity::maxFolded));
  all.push_back(measureOf(world, SanityKind::selfOverlap, selfOverlap, 0, sanity::maxSelfOverlap));
}

/// Returns the worst cell's energy over ½ W A. Surfaces that touch hold W per area [contacts/adhesion.h], so a cell of
/// area A holds at most ½ W A: its neighbours hold the other half. A compressed surface holds more per area, W (a n)²,
/// and less than at rest in all; so A is its area at rest if that is larger.
Worst strongestAdhesion(const World& world, const Observation& now) {
  const Bodies& b = *world.bodies;
  const Contacts& c = *world.contacts;
  std::vector<double> stuck(b.blocks.size() * blockLanes);  // [slot] [length²] energy over ½ W
  for (const PairSum& pair : sumPairs(c, b))
    if (pair.adhesion < 0) stuck[pair.slot] -= 2 * pair.adhesion / workOfAdhesion(c, pair.slot, pair.other);
  Worst worst{0};
  for (int i = 0; i < b.count; ++i) {
    const int slot = b.slots[i];
    const double atRest = restAreaOfVertex(c, b, slot) * b.vertexCount(slot);
    worst.raise(stuck[slot] / std::max(ObservedCell(now, i).physical()->getShape().area, atRest), i);
  }
  return worst;
}

bool hasAdhesionEnergy(const World& world) {
  return world.contacts && world.contacts->parameters.adhesion && world.contacts->parameters.law == ContactLaw::pair &&
         !world.bodies->areSpheres();
}

SanityMeasure overlapOf(const World& world, const std::vector<Mesh>& surfaces) {
  return measureOf(world, SanityKind::overlap, largestOverlap(*world.bodies, surfaces), 0, sanity::maxOverlap);
}

}  // namespace

std::optional<SanityMeasure> measureCellOverlap(const World& world) {
  if (!world.bodies || world.bodies->count < 2) return {};
  const Bodies& b = *world.bodies;
  if (maxBroken(b).cell >= 0) return {};
  std::vector<Mesh> surfaces;
  for (int slot : b.slots) surfaces.push_back(takeContactSurface(world.contacts.get(), b, slot));
  return overlapOf(world, surfaces);
}

std::vector<SanityMeasure> measureSanity(const World& world) {
  if (!world.bodies || world.bodies->count == 0) return {};
  const Bodies& b = *world.bodies;
  std::vector<SanityMeasure> all{measureOf(world, SanityKind::finite, maxBroken(b), 0, 0)};
  if (!all[0].holds()) return all;

  const Observation now(world);
  const auto valueOf = [](const char* name, const CellContext& cell) { return *measure<CellContext>(name).get(cell); };
  std::vector<Mesh> surfaces;
  std::vector<Point> centres;
  Worst least{1}, most{1}, inverted{0};
  double largest = 0, filled = 0;
  for (int i = 0; i < b.count; ++i) {
    const ObservedCell cell(now, i);
    const double volume = valueOf("volume_over_rest", cell);
    least.lower(volume, i);
    most.raise(volume, i);
    inverted.raise(valueOf("inverted", cell), i);
    surfaces.push_back(takeContactSurface(world.contacts.get(), b, b.slots[i]));
    filled += b.areSpheres() ? valueOf("volume", cell) : measureVolume(surfaces[i].vertices, surfaces[i].faces);
    const Box box = measureBox(surfaces[i].vertices);
    largest = std::max(largest, 0.5 * norm(box.high - box.low));
    centres.push_back(measureCentroid(surfaces[i].vertices));
  }
  const bool crushed = !(least.value >= sanity::minVolume);
  const Worst& worst = crushed ? least : most;
  all.push_back(measureOf(world, SanityKind::volume, worst, sanity::minVolume, sanity::maxVolume));
  all.push_back(measureOf(world, SanityKind::inverted, inverted, 0, sanity::maxInverted));
  addSurfaceMeasures(world, now, all);
  if (hasAdhesionEnergy(world))
    all.push_back(measureOf(world, SanityKind::adhesion, strongestAdhesion(world, now), 0, sanity::maxAdhesion));
  if (b.count > 1) {
    all.push_back(overlapOf(world, surfaces));
    all.push_back(measureOf(world, SanityKind::gap, widestGap(centres, largest), 0, sanity::maxGap));
  }
  if (b.parameters.shell) {
    Worst outermost{0};
    for (int cell = 0; cell < b.count; ++cell) outermost.raise(measureOutermost(b, b.slots[cell]), cell);
    all.push_back(measureOf(world, SanityKind::outermost, outermost, 0, sanity::maxOutermost));
    all.push_back(
        measureOf(world, SanityKind::fill, {filled / measureShellVolume(*b.parameters.shell)}, 0, sanity::maxFill));
  }
  return all;
}

}  // namespace morula
