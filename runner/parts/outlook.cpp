#include "parts/outlook.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/maths.h"
#include "bench/packed_world.h"
#include "mesh/measures.h"
#include "simulation/population.h"

namespace morula {

namespace {

// If the rehearsal did not come to two cells: what the thesis' scenes need.
constexpr double usualSearches = 40;  // of an era with two cells
constexpr double usualPairs = 6.2;    // of a vertex in a face that touches another cell's

/// The share of all surfaces that touches another cell, when N equal cells fill a sphere: all but its own
/// surface. The cells' surfaces are 1.19 times those of spheres: exact for two halves, near enough for more.
double touchingShare(double cells) { return cells < 2 ? 0 : 1 - 1 / (1.19 * cubeRoot(cells)); }

/// How eras with contact went that are over, or the last one if none is.
struct ContactTrend {
  double pairs = usualPairs;                   // of a touching vertex
  double searches = usualSearches, cells = 2;  // of the latest era, and how many lived in it
};

ContactTrend measureContactTrend(const Life& life, const Rehearsal& rehearsal) {
  ContactTrend trend;
  bool found = false;
  const std::size_t count = rehearsal.stretches.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Stretch& s = rehearsal.stretches[i];
    const double cells = double(life.eras[i].cells);
    const bool over = i + 1 < count || rehearsal.whole;
    if (s.pairs == 0 || cells < 2 || (!over && found)) continue;
    const double pairs = double(s.pairs) / (double(s.steps) * cells * rehearsal.world.bodies->vertexCount()) /
                         touchingShare(cells);
    // Freshly cut faces are crowded; the least crowded era is what others come to.
    trend = {found ? std::min(trend.pairs, pairs) : pairs, double(s.rebuilds), cells};
    found = true;
  }
  return trend;
}

std::size_t scaled(std::size_t bytes, double by) { return static_cast<std::size_t>(double(bytes) * by); }

}  // namespace

CellTrend measureTrend(const World& world) {
  const Bodies& b = *world.bodies;
  const double egg = b.parameters.cell.mass;
  CellTrend trend;
  double mass = 0, volume = 0;
  for (int i = 0; i < b.count; ++i) {
    const int slot = b.slots[i];
    mass += b.mass(slot);
    volume += b.volume[slot];
    const int depth = world.cells.path[i].depth();
    if (depth == 0) continue;
    // The lightest is light because at each division it was the lighter one.
    const double share = std::ldexp(b.mass(slot) / egg, depth);
    trend.lightness = std::min(trend.lightness, std::pow(share, 1.0 / depth));
  }
  const double eggVolume = measureVolume(b.mesh.mesh.vertices, b.mesh.mesh.faces);
  if (b.count > 0) trend.compression = std::min(volume / eggVolume * egg / mass, 1.0);
  return trend;
}

std::optional<double> foretellTimeStep(const Scene& scene, int generation, const CellTrend& trend) {
  World world = makeWorld(scene);
  Body cell = makeEgg(*world.bodies);
  const double uneven = std::pow(trend.lightness, generation);
  const double share = std::ldexp(uneven, -generation), scale = cubeRoot(share * trend.compression);
  for (Point& x : cell.position) x *= scale;
  cell.mass *= share;
  cell.pressureConstant *= share;
  // Each cut makes `production` times the membrane, for two.
  const double production = scene.mechanics->physics.membrane.production;
  cell.restScale = cubeRoot(uneven) * std::pow(production / 2, 0.5 * generation);
  try {
    World small = makeWorldOf(scene, {CellPath{}}, {cell}, {});
    beginWithBodies(small);
    return small.clock.timeStep;
  } catch (const NumericalError&) { return std::nullopt; }
}

std::vector<Outlook> lookAhead(const Life& life, const Rehearsal& rehearsal) {
  const World& world = rehearsal.world;
  const CellTrend trend = measureTrend(world);
  const double vertices = world.bodies->vertexCount();
  const ContactTrend contact = measureContactTrend(life, rehearsal);
  std::vector<Outlook> all;
  int generation = -1;
  double timeStep = world.clock.timeStep;
  for (std::size_t i = 0; i < life.eras.size(); ++i) {
    const Era& era = life.eras[i];
    const double cells = double(era.cells);
    Outlook o;
    double from = era.from;
    if (i < rehearsal.stretches.size()) {
      const Stretch& s = rehearsal.stretches[i];
      o = {double(s.steps), double(s.rebuilds), double(s.pairs)};
      from = s.until;
      if (i + 1 < rehearsal.stretches.size() || rehearsal.whole) {
        all.push_back(o);
        continue;
      }
    } else if (era.generation != generation) {
      timeStep = foretellTimeStep(world.model, generation = era.generation, trend).value_or(timeStep);
    }
    const double steps = std::ceil(std::max(era.to - from, 0.0) / timeStep);
    o.steps += steps;
    if (world.contacts && cells > 1) {
      o.pairs += steps * cells * vertices * contact.pairs * touchingShare(cells);
      // Cells that part are pushed on through the organism: in edges its size goes with the root.
      const double expected = contact.searches * cubeRoot(cells / contact.cells);
      o.searches = std::min(std::max(o.searches, expected), o.steps);
    }
    all.push_back(o);
  }
  return all;
}

MemoryUse foretellMemory(const Life& life, const Rehearsal& rehearsal) {
  const World& world = rehearsal.world;
  const Bodies& b = *world.bodies;
  MemoryUse m = measureMemory(world);
  const double cells = double(life.mostCells()), here = b.count;
  if (here == 0) return m;
  const double ever = double(2 * life.divisions + 1), everHere = double(world.lineage.entries.size());
  const double blocks = std::ceil(cells / blockLanes) / b.blockCount();
  m.cells = scaled(m.cells, ever / everHere);
  m.connections = scaled(m.connections, ever / everHere);
  for (std::size_t* bytes : {&m.bodies, &m.snapshots, &m.listRows}) *bytes = scaled(*bytes, blocks);
  m.search = scaled(m.search, cells / here);
  if (world.contacts && here < cells) {
    const double pairs = double(world.contacts->list.pairs);
    const double perPair = here > 1 && pairs > 0 ? double(m.listPairs) / pairs : 12;
    const double perVertex = measureContactTrend(life, rehearsal).pairs * touchingShare(cells);
    m.listPairs = static_cast<std::size_t>(perPair * perVertex * cells * b.vertexCount());
  }
  return m;
}

}  // namespace morula
