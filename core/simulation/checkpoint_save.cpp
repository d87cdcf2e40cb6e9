// A world's state as columns.
#include <cmath>
#include <map>

#include "simulation/saved_state.h"
#include "simulation/world.h"

namespace morula {

namespace {

/// The states' descriptions, each once.
class States {
 public:
  States(const World& world, Texts& descriptions) : world_(world), descriptions_(descriptions) {}
  std::uint64_t placeOf(StateId state) {
    const auto [at, isNew] = places_.try_emplace(state, descriptions_.size());
    if (isNew) descriptions_.push_back(world_.biology->describe(state));
    return at->second;
  }

 private:
  const World& world_;
  Texts& descriptions_;
  std::map<StateId, std::uint64_t> places_;
};

void describeCells(SavedState& s, States& states, const World& world) {
  const Cells& c = world.cells;
  for (const CellPath& path : c.path) s.cells.path.push_back(path.text());
  for (StateId state : c.state) s.cells.state.push_back(states.placeOf(state));
  s.cells.lastCycle = c.lastCycle;
  s.cells.growth = c.growth;
  s.cells.entry.assign(c.entry.begin(), c.entry.end());
}

void describeLineage(SavedState& s, States& states, const World& world) {
  for (const LineageEntry& e : world.lineage.entries) {
    s.lineage.path.push_back(e.path.text());
    s.lineage.born.push_back(e.born);
    s.lineage.ended.push_back(e.ended);
    s.lineage.bornStep.push_back(e.bornStep);
    s.lineage.endedStep.push_back(e.endedStep);
    s.lineage.fate.push_back(static_cast<std::uint64_t>(e.fate));
    s.lineage.state.push_back(states.placeOf(e.state));
  }
}

void describeDivisions(SavedState& s, const World& world) {
  for (const DivisionRecord& d : world.divisions) {
    s.divisions.path.push_back(d.path.text());
    s.divisions.time.push_back(d.time);
    s.divisions.step.push_back(d.step);
    s.divisions.axis.insert(s.divisions.axis.end(), {d.axis.x, d.axis.y, d.axis.z});
    s.divisions.share.push_back(d.share);
    s.divisions.extentRatio.push_back(d.extentRatio.value_or(0));
  }
}

Columns vectorsOf(const Bodies& b, const Reals& array) {
  Columns values;
  values.reserve(std::size_t(b.livingVertices) * 3);
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      const Vector u = b.read(array, slot, v);
      values.insert(values.end(), {u.x, u.y, u.z});
    }
  return values;
}

template <class Array>
Columns ofCells(const Bodies& b, const Array& perSlot) {
  Columns values;
  for (int slot : b.slots) values.push_back(perSlot[slot]);
  return values;
}

void describeBodies(SavedState& s, const Bodies& b) {
  for (int slot : b.slots) s.bodies.coarseness.push_back(b.blocks[slot / blockLanes].coarseness);
  s.bodies.vertexMass = ofCells(b, b.vertexMass);
  s.bodies.restScale = ofCells(b, b.restScale);
  s.bodies.pressureConstant = ofCells(b, b.pressureConstant);
  s.bodies.volume = ofCells(b, b.volume);
  s.bodies.pressure = ofCells(b, b.pressure);
  s.bodies.position = vectorsOf(b, b.position);
  s.bodies.velocity = vectorsOf(b, b.velocity);
  s.bodies.acceleration = vectorsOf(b, b.acceleration);
}

void describeContacts(SavedState& s, const Contacts& c, const Bodies& b) {
  s.contacts.radius = ofCells(b, c.radius);
  for (int slot : b.slots) {
    const std::size_t first = b.at(slot, 0) / vertexStride * blockLanes + slot % blockLanes;
    s.contacts.shownRadius.push_back(
        1 / std::sqrt(double(readRow(c.rows[first], b.parameters.precision).inverseRadiusSquared)));
  }
  s.contacts.reference = vectorsOf(b, c.list.reference);
  s.contacts.listIsValid = c.listIsValid;
  const SearchCounters& n = c.list.counters;
  s.contacts.counters = {c.rebuilds,  c.pairEvaluations, n.searches, n.pairs,         n.distanceTests,
                         n.binVisits, n.rootTests,       n.boxTests, n.boxesRefitted, n.treesBuilt};
}

void describeConnections(SavedState& s, const Connections& c) {
  for (const ConnectionRecord& r : c.history) {
    s.connections.a.push_back(r.a.text());
    s.connections.b.push_back(r.b.text());
    s.connections.made.push_back(r.made);
    s.connections.released.push_back(r.released);
    s.connections.cause.push_back(r.cause);
  }
}

}  // namespace

SavedState describeState(const World& world) {
  SavedState s;
  const Clock& c = world.clock;
  s.time = c.time, s.step = c.step, s.timeStep = c.timeStep;
  s.epochTime = c.epochTime, s.epochStep = c.epochStep, s.nextCycle = c.nextCycle;
  States states(world, s.states);
  describeCells(s, states, world);
  describeLineage(s, states, world);
  for (const TimeStepChange& t : world.timeSteps) {
    s.timeSteps.time.push_back(t.time);
    s.timeSteps.step.push_back(t.step);
    s.timeSteps.timeStep.push_back(t.timeStep);
  }
  if (world.bodies) {
    describeDivisions(s, world);
    describeBodies(s, *world.bodies);
  }
  if (world.contacts) describeContacts(s, *world.contacts, *world.bodies);
  if (world.connections) describeConnections(s, *world.connections);
  return s;
}

}  // namespace morula
