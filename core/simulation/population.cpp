
#include "simulation/population.h"

#include <algorithm>

#include "base/error.h"
#include "base/maths.h"
#include "division/coarsen.h"
#include "division/cut.h"
#include "division/place_plane.h"
#include "division/principal_axis.h"
#include "observation/sanity.h"
#include "physics/growth.h"
#include "simulation/make_world.h"
#include "simulation/memory.h"

namespace morula {
namespace {

Point centreOfBody(const Body& body) { return measureCentroid(body.position); }

struct Division {
  Cut cut;
  Daughters daughters;
  DivisionRecord record;
};

Division divide(const World& world, const ObservedCell& cell) {
  const Bodies& bodies = *world.bodies;
  const Body mother = takeBody(bodies, cell.slot());
  Cut cut = world.divisionPolicy->findCut(cell);
  DivisionRecord record{cell.path, world.clock.time, world.clock.step, cut.normal, cut.share.value_or(0.5), {}, {}, {}};
  if (bodies.areSpheres())
    return {cut, divideSphere(mother, bodies.parameters.cell.radius * mother.restScale, cut), record};
  const Faces faces = bodies.meshOf(cell.slot()).mesh.faces;
  record.extentRatio = extentRatio(mother.position);
  if (cut.share) cut.point = placePlane(mother.position, faces, cut.normal, *cut.share);
  CutResult result = cutBody(mother, faces, cut, bodies.parameters.membrane.areaFactor);
  if (!result.failure.empty()) {
    const std::string insane = describeInsanity(world);
    throw NumericalError(
        cell.path.text(), world.clock.step, "the cell cannot divide: " + result.failure,
        insane.empty() ? "give cells time to round off (cycle.length) or stiffer membranes (physics.membrane.stiffness)"
                       : "the cells were not sane before the division: " + insane);
  }
  auto& [a, b] = result.daughters;
  record.share = a.mass / mother.mass;  // mass goes by volume
  if (bodies.model().hasRestShape)      // a volume at rest, and no membrane
    for (Body* daughter : {&a, &b}) daughter->restScale = mother.restScale * cubeRoot(daughter->mass / mother.mass);
  return {cut, {coarsen(bodies, std::move(a)), coarsen(bodies, std::move(b))}, record};
}

/// The daughters that keep a connection of a mother that has just divided [Nilsson 2008, §4.4.3].
struct Heirs {
  bool a, b;
};

/// `centreOf` gives centres of cells of this moment, `centreBefore` where these cells or their mothers were before.
template <class CentreOf, class CentreBefore>
Heirs heirsOf(ConnectionsOnDivision policy, const CellPath& mother, const CellPath& other, const Cut& cut,
              const CentreOf& centreOf, const CentreBefore& centreBefore) {
  if (policy == ConnectionsOnDivision::both) return {true, true};
  if (policy == ConnectionsOnDivision::a) return {true, false};
  bool isNearA;
  if (policy == ConnectionsOnDivision::nearest) {
    // Goes by where the other cell was: it may divide, too, and the order of the two must not matter.
    const Point there = centreBefore(other);
    isNearA = norm(centreOf(mother.daughter(false)) - there) <= norm(centreOf(mother.daughter(true)) - there);
  } else {
    isNearA = dot(centreOf(other) - cut.point, cut.normal) >= 0;
  }
  return {isNearA, !isNearA};
}

/// Passes on old connections first, then connects the sisters: ConnectionParameters::most leaves out theirs.
template <class... Centres>
void inheritConnections(Connections& c, const CellPath& mother, const Cut& cut, double time,
                        const Centres&... centres) {
  const CellPath a = mother.daughter(false), b = mother.daughter(true);
  for (const CellPath& other : partners(c, mother)) {
    release(c, mother, other, time, ReleaseCause::divided);
    const Heirs heirs = heirsOf(c.parameters.onDivision, mother, other, cut, centres...);
    if (heirs.a) connect(c, a, other, time);
    if (heirs.b) connect(c, b, other, time);
  }
  const MakeConnections make = c.parameters.make;
  if (make == MakeConnections::atDivision || make == MakeConnections::both) connect(c, a, b, time);
}

struct Population {
  Cells cells;
  std::vector<Body> bodies;
  std::vector<BirthSize> birthSizes;  // 0 for newborns; empty where no division asks for them
};

void add(Population& p, const CellPath& path, StateId state, double lastCycle, double growth, std::uint32_t entry) {
  p.cells.path.push_back(path);
  p.cells.state.push_back(state);
  p.cells.lastCycle.push_back(lastCycle);
  p.cells.growth.push_back(growth);
  p.cells.entry.push_back(entry);
}

void closeEntry(World& world, std::size_t i, Fate fate) {
  LineageEntry& entry = world.lineage.entries[world.cells.entry[i]];
  entry.fate = fate;
  entry.ended = world.clock.time;
  entry.endedStep = world.clock.step;
}

/// Records a daughter's birth and adds her to the population.
void addDaughter(World& world, Population& next, std::size_t mother, bool b) {
  const Cells& cells = world.cells;
  const StateId state = world.biology->daughterState(cells.state[mother], b);
  const CellPath path = cells.path[mother].daughter(b);
  add(next, path, state, cells.lastCycle[mother], cells.growth[mother],
      static_cast<std::uint32_t>(world.lineage.entries.size()));
  if (world.birthSizes) next.birthSizes.push_back({});
  world.lineage.entries.push_back({path, world.clock.time, 0, world.clock.step, 0, Fate::alive, state});
}

/// Passes on the connections of all mothers. `cuts`: of the cells that divide, by path.
void inheritAllConnections(World& world, const std::vector<CellChange>& changes, const std::vector<Cut>& cuts,
                           const Population& next) {
  if (!world.connections) return;
  const double time = world.clock.time;
  // A cell that still stands in the list under its mother's name is looked up by its mother's old body.
  const auto centreOf = [&](const CellPath& path) {
    if (const int now = cellNumber(next.cells, path); now >= 0) return centreOfBody(next.bodies[now]);
    return measureCentre(*world.bodies, world.bodies->slots[cellNumber(world.cells, path)]);
  };
  const auto centreBefore = [&](const CellPath& path) {
    const int number = cellNumber(world.cells, path);
    return measureCentre(*world.bodies,
                         world.bodies->slots[number >= 0 ? number : cellNumber(world.cells, path.mother())]);
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i] == CellChange::dies) releaseAll(*world.connections, world.cells.path[i], time, ReleaseCause::died);
  std::size_t division = 0;
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i] == CellChange::divides)
      inheritConnections(*world.connections, world.cells.path[i], cuts[division++], time, centreOf, centreBefore);
}

/// Sorts in the polarities that mothers left to their daughters.
void keepPolarities(World& world, const std::vector<CellChange>& changes, const std::vector<Cut>& cuts) {
  if (!world.polarities) return;
  std::size_t division = 0;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i] != CellChange::divides) continue;
    if (const auto& polarity = cuts[division++].polarity) world.polarities->push_back({world.cells.path[i], *polarity});
  }
  std::ranges::sort(*world.polarities, {}, &PolarityRecord::path);
}

/// Throws if the changes need too much memory. Daughters have no more vertices than their mother.
void requireMemoryFor(const World& world, const std::vector<CellChange>& changes) {
  double cells = double(world.lineage.entries.size());
  double vertices = world.bodies ? double(world.bodies->lineCount()) * blockLanes : 0;
  const CellPath* last = nullptr;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i] != CellChange::divides) continue;
    last = &world.cells.path[i];
    cells += 2;
    if (world.bodies) vertices += world.bodies->vertexCount(world.bodies->slots[i]);
  }
  if (last) requireMemory(world, *last, cells, vertices);
}

}  // namespace

void addFounder(World& world, const CellPath& path, StateId state) {
  world.cells.path.push_back(path);
  world.cells.state.push_back(state);
  world.cells.lastCycle.push_back(0);
  world.cells.growth.push_back(0);
  world.cells.entry.push_back(static_cast<std::uint32_t>(world.lineage.entries.size()));
  world.lineage.entries.push_back({path, 0, 0, 0, 0, Fate::alive, state});
}

void changePopulation(World& world, const Observation& now, const std::vector<CellChange>& changes) {
  const auto changesHere = [](CellChange c) { return c == CellChange::divides || c == CellChange::dies; };
  if (std::none_of(changes.begin(), changes.end(), changesHere)) return;

  requireMemoryFor(world, changes);

  // Makes all cuts first: an error leaves the world as it is.
  std::vector<Division> divisions;
  if (world.bodies)
    for (std::size_t i = 0; i < changes.size(); ++i)
      if (changes[i] == CellChange::divides) divisions.push_back(divide(world, ObservedCell(now, static_cast<int>(i))));

  Population next;
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i] == CellChange::dies) {
      closeEntry(world, i, Fate::died);  // the cell leaves the physics and stays in the lineage
    } else if (changes[i] == CellChange::divides) {
      closeEntry(world, i, Fate::divided);
      addDaughter(world, next, i, false);
      addDaughter(world, next, i, true);
      if (world.bodies) {
        auto& [cut, daughters, record] = divisions[cuts.size()];
        record.centreA = centreOfBody(daughters.a);
        record.centreB = centreOfBody(daughters.b);
        next.bodies.push_back(std::move(daughters.a));
        next.bodies.push_back(std::move(daughters.b));
        world.divisions.push_back(record);
        cuts.push_back(cut);
      }
    } else {
      const Cells& c = world.cells;
      add(next, c.path[i], c.state[i], c.lastCycle[i], c.growth[i], c.entry[i]);
      if (world.birthSizes) next.birthSizes.push_back((*world.birthSizes)[i]);
      if (world.bodies) next.bodies.push_back(takeBody(*world.bodies, world.bodies->slots[i]));
    }
  }
  inheritAllConnections(world, changes, cuts, next);
  keepPolarities(world, changes, cuts);
  world.cells = std::move(next.cells);
  if (!world.bodies) return;
  setBodies(*world.bodies, next.bodies);
  if (world.birthSizes) {
    world.birthSizes = std::move(next.birthSizes);
    for (std::size_t i = 0; i < world.birthSizes->size(); ++i)
      if (double& size = (*world.birthSizes)[i].size; size == 0)
        size = sizeAtRest(*world.bodies, world.bodies->slots[i]);
  }
  beginWithBodies(world);
}

}  // namespace morula
