#pragma once
// What a checkpoint holds: everything that the continuation depends on, in columns. Private to
// checkpoint*.cpp.
#include <cstdint>
#include <string>
#include <vector>

#include "simulation/world.h"

namespace morula {

using Numbers = std::vector<std::uint64_t>;
using Columns = std::vector<double>;
using Texts = std::vector<std::string>;

struct SavedState {
  double time = 0, timeStep = 0, epochTime = 0, nextCycle = 0;
  std::uint64_t step = 0, epochStep = 0;

  Texts states;  // descriptions; other columns hold places here, for a StateId means nothing in another run

  struct {
    Texts path;
    Numbers state, entry;
    Columns lastCycle, growth;
  } cells;

  struct {
    Texts path;
    Columns born, ended;
    Numbers bornStep, endedStep, fate, state;
  } lineage;

  struct {
    Columns time, timeStep;
    Numbers step;
  } timeSteps;

  struct {  // with physics
    Texts path;
    Columns time, axis, share, extentRatio;  // axis [division][xyz]; ratio 0: not measured
    Numbers step;
  } divisions;

  struct {  // [cell]; with physics
    Numbers coarseness;
    Columns vertexMass, restScale, pressureConstant;
    Columns volume, pressure;
    Columns position, velocity, acceleration;  // [cell][vertex][xyz]
  } bodies;

  struct {  // with contact
    // [cell]; radii follow growth at cell cycles only, so they do not follow from the rest scales.
    Columns radius;
    Columns shownRadius;  // in the last snapshot, that measures are taken from
    // The list is built anew from the positions that it was built at: then it is the same, and its counters
    // go on as if nothing had been.
    Columns reference;  // [cell][vertex][xyz]
    std::uint64_t listIsValid = 0;
    Numbers counters;  // Contacts' two, then SearchCounters' in their order
  } contacts;

  struct {  // with connections, in the order in which they were made
    Texts a, b, cause;
    Columns made, released;
  } connections;
};

/// Calls io(name, field) for every field, in the order of the file; io.reals(name, field) for those that the
/// physics keeps in the scene's precision.
template <class Io, class State>
void forEachField(Io& io, State& s, const World& world) {
  io("clock.time", s.time);
  io("clock.step", s.step);
  io("clock.time step", s.timeStep);
  io("clock.epoch time", s.epochTime);
  io("clock.epoch step", s.epochStep);
  io("clock.next cycle", s.nextCycle);
  io("states", s.states);
  io("cells.path", s.cells.path);
  io("cells.state", s.cells.state);
  io("cells.last cycle", s.cells.lastCycle);
  io("cells.growth", s.cells.growth);
  io("cells.entry", s.cells.entry);
  io("lineage.path", s.lineage.path);
  io("lineage.born", s.lineage.born);
  io("lineage.ended", s.lineage.ended);
  io("lineage.born step", s.lineage.bornStep);
  io("lineage.ended step", s.lineage.endedStep);
  io("lineage.fate", s.lineage.fate);
  io("lineage.state", s.lineage.state);
  io("time steps.time", s.timeSteps.time);
  io("time steps.step", s.timeSteps.step);
  io("time steps.time step", s.timeSteps.timeStep);
  if (world.bodies) {
    io("divisions.path", s.divisions.path);
    io("divisions.time", s.divisions.time);
    io("divisions.step", s.divisions.step);
    io("divisions.axis", s.divisions.axis);
    io("divisions.share", s.divisions.share);
    io("divisions.extent ratio", s.divisions.extentRatio);
    io("bodies.coarseness", s.bodies.coarseness);
    io("bodies.vertex mass", s.bodies.vertexMass);
    io("bodies.rest scale", s.bodies.restScale);
    io("bodies.pressure constant", s.bodies.pressureConstant);
    io("bodies.volume", s.bodies.volume);
    io("bodies.pressure", s.bodies.pressure);
    io.reals("bodies.position", s.bodies.position);
    io.reals("bodies.velocity", s.bodies.velocity);
    io.reals("bodies.acceleration", s.bodies.acceleration);
  }
  if (world.contacts) {
    io("contacts.radius", s.contacts.radius);
    io("contacts.shown radius", s.contacts.shownRadius);
    io.reals("contacts.reference", s.contacts.reference);
    io("contacts.list is valid", s.contacts.listIsValid);
    io("contacts.counters", s.contacts.counters);
  }
  if (world.connections) {
    io("connections.a", s.connections.a);
    io("connections.b", s.connections.b);
    io("connections.made", s.connections.made);
    io("connections.released", s.connections.released);
    io("connections.cause", s.connections.cause);
  }
}

SavedState describeState(const World& world);

/// Throws InputError for a state that no run of this world's scene can have been in; it is then safe to take
/// over.
void checkSavedState(const SavedState& state, const World& world);

/// Puts a checked state into the world.
void takeOver(World& world, const SavedState& state);

}  // namespace morula
