#include "parts/outlook.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "bench/packed_world.h"
#include "simulation/population.h"
#include "simulation/stages.h"

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
    const double pairs = double(s.pairs) /
                         (double(s.steps) * cells * verticesPerCell(*rehearsal.world.bodies)) /
                         touchingShare(cells);
    // Freshly cut faces are crowded; the least crowded era is what others come to.
    trend = {found ? std::min(trend.pairs, pairs) : pairs, double(s.rebuilds), cells};
    found = true;
  }
  return trend;
}

std::size_t scaled(std::size_t bytes, double by) { return static_cast<std::size_t>(double(bytes) * by); }

/// Of an equal part of the egg, free and round.
double idealLimit(const Scene& scene, int generation) {
  Scene any = scene;
  any.mechanics->physics.timeStep.reset();  // to ask is not to use it
  const World egg = makeWorld(any);
  Body cell = makeEgg(*egg.bodies);
  const double share = std::ldexp(1.0, -generation), scale = cubeRoot(share);
  for (Point& x : cell.position) x *= scale;
  cell.mass *= share;
  cell.pressureConstant *= share;
  // Each cut makes `production` times the membrane, for two.
  cell.restScale = std::pow(any.mechanics->physics.membrane.areaFactor / 2, 0.5 * generation);
  World part = makeWorldOf(any, {CellPath{}}, {cell}, {});
  beginWithBodies(part);
  return timeStepLimit(part);
}

}  // namespace

double verticesPerCell(const Bodies& b) {
  return b.count > 0 ? double(b.livingVertices) / b.count : b.mesh.vertexCount();
}

double foretellTimeStepLimit(const Rehearsal& rehearsal, int generation) {
  const Scene& scene = rehearsal.world.model;
  const double ideal = idealLimit(scene, generation);
  if (rehearsal.generation == 0) return ideal;
  const double loss = rehearsal.timeStepLimit / idealLimit(scene, rehearsal.generation);
  return ideal * std::pow(loss, double(generation) / rehearsal.generation);
}

std::vector<Outlook> lookAhead(const Life& life, const Rehearsal& rehearsal) {
  const World& world = rehearsal.world;
  const double vertices = verticesPerCell(*world.bodies);
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
      generation = era.generation;
      const auto& fixed = world.bodies->parameters.timeStep;
      timeStep =
          fixed ? *fixed : automaticTimeStep(world.model.cycle, foretellTimeStepLimit(rehearsal, generation));
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
    m.listPairs = static_cast<std::size_t>(perPair * perVertex * cells * verticesPerCell(b));
  }
  return m;
}

}  // namespace morula
