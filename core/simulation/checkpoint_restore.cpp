// Columns back into a world.
#include <algorithm>

#include "simulation/saved_state.h"
#include "simulation/world.h"

namespace morula {

namespace {

std::vector<StateId> internStates(const Texts& descriptions, BiologicalUnit& biology) {
  std::vector<StateId> ids;
  for (const std::string& text : descriptions) ids.push_back(biology.stateOf(text));
  return ids;
}

Cells makeCells(const SavedState& s, const std::vector<StateId>& states) {
  Cells c;
  for (const std::string& path : s.cells.path) c.path.push_back(CellPath::parse(path));
  for (std::uint64_t place : s.cells.state) c.state.push_back(states[place]);
  c.lastCycle = s.cells.lastCycle;
  c.growth = s.cells.growth;
  c.entry.assign(s.cells.entry.begin(), s.cells.entry.end());
  return c;
}

Lineage makeLineage(const SavedState& s, const std::vector<StateId>& states) {
  const auto& l = s.lineage;
  Lineage lineage;
  for (std::size_t i = 0; i < l.path.size(); ++i)
    lineage.entries.push_back({CellPath::parse(l.path[i]), l.born[i], l.ended[i], l.bornStep[i],
                               l.endedStep[i], static_cast<Fate>(l.fate[i]), states[l.state[i]]});
  return lineage;
}

std::vector<DivisionRecord> makeDivisions(const SavedState& s) {
  const auto& d = s.divisions;
  std::vector<DivisionRecord> divisions;
  for (std::size_t i = 0; i < d.path.size(); ++i)
    divisions.push_back({CellPath::parse(d.path[i]),
                         d.time[i],
                         d.step[i],
                         {d.axis[3 * i], d.axis[3 * i + 1], d.axis[3 * i + 2]},
                         d.share[i],
                         d.extentRatio[i] > 0 ? std::optional(d.extentRatio[i]) : std::nullopt});
  return divisions;
}

/// Of all cells, in the order of lineage paths.
void writeVectors(const Columns& values, const Bodies& b, Reals& array) {
  std::size_t i = 0;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v, i += 3)
      b.write(array, slot, v, {values[i], values[i + 1], values[i + 2]});
}

/// Places only; everything else is written over.
void makeRoom(Bodies& b, const Numbers& coarseness) {
  std::vector<Body> cells;
  for (std::uint64_t c : coarseness) {
    Body cell;
    cell.coarseness = static_cast<int>(c);
    cell.position.resize(b.meshAt(cell.coarseness).vertexCount());
    cell.velocity.resize(cell.position.size());
    cells.push_back(std::move(cell));
  }
  setBodies(b, cells);
}

void placeBodies(const SavedState& s, Bodies& b) {
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    b.vertexMass[slot] = s.bodies.vertexMass[cell];
    b.restScale[slot] = s.bodies.restScale[cell];
    b.pressureConstant[slot] = s.bodies.pressureConstant[cell];
  }
  writeVectors(s.bodies.position, b, b.position);
  writeVectors(s.bodies.velocity, b, b.velocity);
}

/// What the last evaluation left behind.
void placeForces(const SavedState& s, Bodies& b) {
  for (int cell = 0; cell < b.count; ++cell) {
    b.volume[b.slots[cell]] = s.bodies.volume[cell];
    b.pressure[b.slots[cell]] = s.bodies.pressure[cell];
  }
  writeVectors(s.bodies.acceleration, b, b.acceleration);
}

/// As the last step saw the cells, for those who measure contacts before the next one. Writes over forces.
void takeSnapshots(World& world) {
  Bodies& b = *world.bodies;
  for (int i = 0; i < b.blockCount(); ++i) {
    const BlockView block = b.block(i, 0);
    const std::size_t first = std::size_t(b.blocks[i].firstLine) * vertexStride;
    for (int k = 0; k < b.verticesPerLane(i) * vertexStride; ++k)
      b.scratch[0].predicted[k] = b.velocity[first + k];
    const TemplateView mesh = b.meshAt(block.coarseness).view();
    world.stages.findSpringCoefficients(mesh, block, b.kernelParameters);
    world.stages.gatherRings(mesh, block, b.kernelParameters);
    takeSnapshot(*world.contacts, b, block, i);
  }
}

void restoreContacts(const SavedState& s, World& world) {
  Contacts& c = *world.contacts;
  Bodies& b = *world.bodies;
  resetContacts(c, b);
  if (b.count > 0) {
    setInfluenceRadii(c, b, s.contacts.listIsValid ? s.contacts.radius : s.contacts.shownRadius);
    const Reals now = b.position;
    writeVectors(s.contacts.reference, b, b.position);
    buildNeighbourList(c.list, b, c.radius, world.execution.threads);
    b.position = now;
    takeSnapshots(world);
    setInfluenceRadii(c, b, s.contacts.radius);
  }
  c.listIsValid = s.contacts.listIsValid && b.count > 0;
  const Numbers& n = s.contacts.counters;
  c.rebuilds = n[0], c.pairEvaluations = n[1];
  c.list.counters = {n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]};
}

const char* causeOf(const std::string& text) {
  return *std::find(releaseCauses.begin(), releaseCauses.end(), text);
}

void restoreConnections(const SavedState& s, Connections& connections) {
  const auto& c = s.connections;
  connections.history.clear();
  connections.active.clear();
  for (std::size_t i = 0; i < c.a.size(); ++i) {
    connections.history.push_back(
        {CellPath::parse(c.a[i]), CellPath::parse(c.b[i]), c.made[i], c.released[i], causeOf(c.cause[i])});
    if (c.released[i] < 0) connections.active.push_back(i);
  }
  const auto pair = [&](std::size_t i) {
    return std::pair{connections.history[i].a, connections.history[i].b};
  };
  std::sort(connections.active.begin(), connections.active.end(),
            [&](std::size_t i, std::size_t j) { return pair(i) < pair(j); });
}

}  // namespace

void takeOver(World& world, const SavedState& s) {
  world.clock = {s.time, s.step, s.timeStep, s.epochTime, s.epochStep, s.nextCycle};
  const std::vector<StateId> states = internStates(s.states, *world.biology);
  world.cells = makeCells(s, states);
  world.lineage = makeLineage(s, states);
  world.timeSteps.clear();
  for (std::size_t i = 0; i < s.timeSteps.time.size(); ++i)
    world.timeSteps.push_back({s.timeSteps.time[i], s.timeSteps.step[i], s.timeSteps.timeStep[i]});
  if (world.bodies) {
    world.divisions = makeDivisions(s);
    makeRoom(*world.bodies, s.bodies.coarseness);
    placeBodies(s, *world.bodies);
    if (world.contacts) restoreContacts(s, world);
    placeForces(s, *world.bodies);
  }
  if (world.connections) restoreConnections(s, *world.connections);
}

}  // namespace morula
