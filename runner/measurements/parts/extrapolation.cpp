// Extrapolates from the eras that a trial run reached to the later ones.
#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "bench/packed_world.h"
#include "contacts/contacts.h"
#include "parts/trial_run.h"
#include "simulation/make_world.h"
#include "simulation/settle.h"
#include "simulation/simulation.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

/// Returns the share of the cells' surface at which they touch, if N equal cells fill a sphere. Only the surface of the
/// whole sphere touches no cell. A cell's surface is 1.19 times that of a ball with its volume: this is exact for two
/// halves, and near enough for more cells.
double touchingShare(double cells) { return cells < 2 ? 0 : 1 - 1 / (1.19 * cubeRoot(cells)); }

/// The contacts in completed eras, or in the last one if none is complete. The defaults are those of the thesis'
/// scenes.
struct ContactTrend {
  double pairs = 6.2;               // for each vertex where the cell touches another one
  double searches = 40, cells = 2;  // searches and number of cells in the latest era
};

ContactTrend measureContactTrend(const Life& life, const TrialRun& trial) {
  ContactTrend trend;
  bool found = false;
  for (std::size_t i = 0; i < trial.eras.size(); ++i) {
    const EraCounts& era = trial.eras[i];
    const double cells = double(life.eras[i].cells);
    const bool over = i + 1 < trial.eras.size() || trial.whole;
    if (era.pairs == 0 || cells < 2 || (!over && found)) continue;
    const double pairs = era.pairs / (era.steps * cells * verticesPerCell(*trial.world.bodies)) / touchingShare(cells);
    // Vertices crowd on freshly cut faces, so the era with the fewest pairs resembles later eras most.
    trend = {found ? std::min(trend.pairs, pairs) : pairs, era.searches, cells};
    found = true;
  }
  return trend;
}

/// Returns the stability limit of the time step for a free, round cell that equal divisions have made of the egg.
double idealLimit(const Scene& scene, int generation) {
  Scene any = scene;
  any.mechanics->physics.timeStep.reset();  // makeWorld would throw if a fixed time step lies above the limit
  Body cell = makeEgg(*makeWorld(any).bodies);
  const double share = std::ldexp(1.0, -generation), scale = cubeRoot(share);
  for (Point& x : cell.position) x *= scale;
  cell.mass *= share;
  cell.pressureConstant *= share;
  // Each division multiplies the membrane's area by `areaFactor`, and two cells share it.
  cell.restScale = std::pow(any.mechanics->physics.membrane.areaFactor / 2, 0.5 * generation);
  World part = makeWorldOf(any, {CellPath{}}, {cell}, {});
  beginWithBodies(part);
  return timeStepLimit(part);
}

}  // namespace

double verticesPerCell(const Bodies& b) {
  return b.count > 0 ? double(b.livingVertices) / b.count : b.mesh.vertexCount();
}

double predictTimeStepLimit(const TrialRun& trial, int generation) {
  const Scene& scene = trial.world.model;
  const double ideal = idealLimit(scene, generation);
  if (trial.generation == 0) return ideal;
  const double loss = trial.timeStepLimit / idealLimit(scene, trial.generation);
  return ideal * std::pow(loss, double(generation) / trial.generation);
}

std::vector<EraCounts> extrapolate(const Life& life, const TrialRun& trial) {
  const World& world = trial.world;
  const double vertices = verticesPerCell(*world.bodies);
  const ContactTrend contact = measureContactTrend(life, trial);
  const auto& fixed = world.bodies->parameters.timeStep;
  std::vector<EraCounts> all = trial.eras;
  all.resize(life.eras.size());
  // The trial run's last era is incomplete.
  const std::size_t first = trial.whole ? trial.eras.size() : trial.eras.size() - 1;
  int generation = -1;
  double timeStep = world.clock.timeStep, from = world.clock.time;
  for (std::size_t i = first; i < all.size(); ++i) {
    const Era& era = life.eras[i];
    EraCounts& counts = all[i];
    if (i >= trial.eras.size()) {
      from = era.from;
      if (era.generation != generation && !world.settlings)
        timeStep = fixed ? *fixed : automaticTimeStep(world.model, predictTimeStepLimit(trial, era.generation));
      generation = era.generation;
    }
    const double cells = double(era.cells);
    double steps = std::ceil(std::max(era.to - from, 0.0) / timeStep);
    if (world.settlings)
      steps = trial.whole ? 0 : std::max(era.to - from, 0.0) * evaluationsPerTime(world.model, int(vertices));
    counts.steps += steps;
    if (!world.contacts || cells < 2) continue;
    counts.pairs += steps * cells * vertices * contact.pairs * touchingShare(cells);
    // Dividing cells push others through the whole organism, whose diameter grows with the cube root of their number.
    const double expected = contact.searches * cubeRoot(cells / contact.cells);
    counts.searches = std::min(std::max(counts.searches, expected), counts.steps);
  }
  return all;
}

MemoryUse extrapolateMemory(const Life& life, const TrialRun& trial) {
  const World& world = trial.world;
  const Bodies& b = *world.bodies;
  MemoryUse m = measureMemory(world);
  const double cells = double(life.maxCells()), here = b.count;
  if (here == 0) return m;
  const auto scale = [](double by, std::initializer_list<std::size_t*> sizes) {
    for (std::size_t* bytes : sizes) *bytes = static_cast<std::size_t>(double(*bytes) * by);
  };
  scale(double(2 * life.divisions + 1) / double(world.lineage.entries.size()), {&m.cells, &m.connections});
  scale(std::ceil(cells / blockLanes) / b.blockCount(), {&m.bodies, &m.snapshots, &m.listRows});
  scale(cells / here, {&m.search});
  if (world.contacts && here < cells) {
    const double perPair = world.contacts->list.bytesPerNeighbour - 5;  // 5 bytes are used only while lists are moved
    const double perVertex = measureContactTrend(life, trial).pairs * touchingShare(cells);
    m.listPairs = static_cast<std::size_t>(perPair * perVertex * cells * verticesPerCell(b));
  }
  return m;
}

}  // namespace morula
