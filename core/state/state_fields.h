#pragma once
// Every field of a world's state, listed once: for its hash (hash.cpp), for checkpoints (checkpoint_save.cpp,
// checkpoint_restore.cpp) and for the first difference of two states (runner/runs/explain/explain.cpp).
//
// Each list takes its struct apart into all of its members: a new member that is not listed does not compile.
#include <concepts>
#include <span>

#include "base/record.h"
#include "state/world.h"

namespace morula {

/// The users of a field besides checkpoints, which hold all fields.
enum class Use {
  result,    // hashes and differences
  compared,  // differences; the field follows from hashed fields
  saved,     // checkpoints alone: the field follows from the others, or tells how the state came about
};

struct Field {
  const char* name;   // name in checkpoints, after the table's; a body's also in the hash
  const char* label;  // name in differences, for people
  Use use = Use::result;
};

/// Numbers of states mean nothing in another run; their description counts.
template <class Numbers>
struct StateNumbers {
  Numbers& of;  // one StateId, or a vector of them
};
template <class Numbers>
StateNumbers(Numbers&) -> StateNumbers<Numbers>;

// visitFields(record, visit) calls visit(Field, member) for each member that is state, in the order of checkpoints.

template <IsA<Clock> T>
void visitFields(T& clock, auto&& visit) {
  auto& [time, step, timeStep, epochTime, epochStep, nextCycle] = clock;
  visit(Field{"time", "clock.time"}, time);
  visit(Field{"step", "clock.step"}, step);
  visit(Field{"time step", "clock.time step"}, timeStep);
  visit(Field{"epoch time", "clock.epoch's time"}, epochTime);
  visit(Field{"epoch step", "clock.epoch's step"}, epochStep);
  visit(Field{"next cycle", "clock.next cell cycle", Use::compared}, nextCycle);
}

/// Members are columns, [cell].
template <IsA<Cells> T>
void visitFields(T& cells, auto&& visit) {
  auto& [path, state, lastCycle, growth, entry] = cells;
  visit(Field{"path", "path"}, path);
  visit(Field{"state", "substances"}, StateNumbers{state});
  visit(Field{"last cycle", "last cell cycle"}, lastCycle);
  visit(Field{"growth", "growth"}, growth);
  visit(Field{"entry", "", Use::saved}, entry);
}

template <IsA<LineageEntry> T>
void visitFields(T& cell, auto&& visit) {
  auto& [path, born, ended, bornStep, endedStep, fate, state] = cell;
  visit(Field{"path", "path in the lineage"}, path);
  visit(Field{"born", "born"}, born);
  visit(Field{"ended", "ended"}, ended);
  visit(Field{"born step", "born at step"}, bornStep);
  visit(Field{"ended step", "ended at step"}, endedStep);
  visit(Field{"fate", "fate"}, fate);
  visit(Field{"state", "substances in the lineage"}, StateNumbers{state});
}

template <IsA<TimeStepChange> T>
void visitFields(T& change, auto&& visit) {
  auto& [time, step, timeStep] = change;
  visit(Field{"time", "", Use::saved}, time);
  visit(Field{"step", "", Use::saved}, step);
  visit(Field{"time step", "", Use::saved}, timeStep);
}

template <IsA<DivisionRecord> T>
void visitFields(T& division, auto&& visit) {
  auto& [path, time, step, axis, share, extentRatio, centreA, centreB] = division;
  visit(Field{"path", "", Use::saved}, path);
  visit(Field{"time", "", Use::saved}, time);
  visit(Field{"step", "", Use::saved}, step);
  visit(Field{"axis", "", Use::saved}, axis);
  visit(Field{"share", "", Use::saved}, share);
  visit(Field{"extent ratio", "", Use::saved}, extentRatio);
  visit(Field{"centre a", "", Use::saved}, centreA);
  visit(Field{"centre b", "", Use::saved}, centreB);
}

template <IsA<PolarityRecord> T>
void visitFields(T& polarity, auto&& visit) {
  auto& [path, direction] = polarity;
  visit(Field{"path", "", Use::saved}, path);
  visit(Field{"direction", "", Use::saved}, direction);
}

template <IsA<SettlingRecord> T>
void visitFields(T& settling, auto&& visit) {
  auto& [time, step, cells, evaluations, residual, energyLeft, displacementLeft] = settling;
  visit(Field{"time", "", Use::saved}, time);
  visit(Field{"step", "", Use::saved}, step);
  visit(Field{"cells", "", Use::saved}, cells);
  visit(Field{"evaluations", "", Use::saved}, evaluations);
  visit(Field{"residual", "", Use::saved}, residual);
  visit(Field{"energy_left", "", Use::saved}, energyLeft);
  visit(Field{"displacement_left", "", Use::saved}, displacementLeft);
}

template <IsA<ExperimentRecord> T>
void visitFields(T& record, auto&& visit) {
  auto& [number, time, step, to, path, other] = record;
  visit(Field{"number", "experiment"}, number);
  visit(Field{"time", "experiment's time"}, time);
  visit(Field{"step", "experiment's step"}, step);
  visit(Field{"to", "experiment done to"}, to);
  visit(Field{"path", "experiment on"}, path);
  visit(Field{"other", "experiment with"}, other);
}

template <IsA<BirthSize> T>
void visitFields(T& birth, auto&& visit) {
  auto& [size] = birth;
  visit(Field{"size", "", Use::saved}, size);
}

template <IsA<ConnectionRecord> T>
void visitFields(T& connection, auto&& visit) {
  auto& [a, b, made, released, cause] = connection;
  visit(Field{"a", "connection from"}, a);
  visit(Field{"b", "connection to"}, b);
  visit(Field{"made", "connection made"}, made);
  visit(Field{"released", "connection released"}, released);
  visit(Field{"cause", "connection's end"}, cause);
}

/// Members are columns: [slot], or Reals of a vector per vertex. The cells' meshes come before them, and stand in the
/// blocks.
template <IsA<Bodies> T>
void visitFields(T& bodies, auto&& visit) {
  auto& [parameters, kernelParameters, mesh, surface, coarser, count, slots, blocks, livingVertices, position, velocity,
         acceleration, vertexMass, restScale, pressureConstant, sag, substeps, volume, pressure, scratch] = bodies;
  visit(Field{"vertex mass", "vertex mass"}, vertexMass);
  visit(Field{"rest scale", "rest scale"}, restScale);
  visit(Field{"pressure constant", "pressure constant"}, pressureConstant);
  visit(Field{"volume", "", Use::saved}, volume);
  visit(Field{"pressure", "", Use::saved}, pressure);
  visit(Field{"position", "position"}, position);
  visit(Field{"velocity", "velocity"}, velocity);
  visit(Field{"acceleration", "acceleration"}, acceleration);
}

/// Visits the fields of one cell in Cells.
void visitCell(const Cells& cells, std::size_t cell, auto&& visit) {
  visitFields(cells, [&](const Field& field, const auto& column) {
    if constexpr (requires { column.of; }) visit(field, StateNumbers{column.of[cell]});
    else visit(field, column[cell]);
  });
}

/// Visits the fields of one cell's body: numbers, and vectors as a span [vertex][xyz] that is valid during the visit.
void visitBody(const Bodies& bodies, int slot, auto&& visit) {
  std::vector<double> vectors;
  visitFields(bodies, [&]<class Member>(const Field& field, const Member& member) {
    if constexpr (!std::same_as<Member, Reals>) {
      visit(field, member[slot]);
    } else {
      vectors.clear();
      for (int v = 0; v < bodies.vertexCount(slot); ++v) {
        const Vector u = bodies.read(member, slot, v);
        vectors.insert(vectors.end(), {u.x, u.y, u.z});
      }
      visit(field, std::span<const double>(vectors));
    }
  });
}

/// Calls visit(name, part) for each part of the state that the world has, in the order of checkpoints: a
/// record, columns (Cells, Bodies), rows (a vector of records), or Contacts, whose state follows from the
/// positions at which its list was built.
template <IsA<World> W>
void visitState(W& world, auto&& visit) {
  auto& [model, execution, biology, divisionPolicy, stages, stagesOfLanes, clock, cells, bodies, contacts, connections,
         lineage, timeSteps, divisions, birthSizes, polarities, settlings, experiments, stoppedBy, before, motility,
         swirls] = world;
  visit("clock", clock);
  visit("cells", cells);
  visit("lineage", lineage.entries);
  visit("time steps", timeSteps);
  if (bodies) {
    visit("divisions", divisions);
    visit("bodies", *bodies);
  }
  if (polarities) visit("polarities", *polarities);
  if (contacts) visit("contacts", *contacts);
  if (connections) visit("connections", connections->history);
  if (birthSizes) visit("birth sizes", *birthSizes);
  if (settlings) visit("settlings", *settlings);
  if (experiments) visit("experiments", *experiments);
}

/// Leaves out the parts that only checkpoints hold, because they tell how the state came about, or follow from
/// positions. Base of visitors that hash or compare states.
struct SavedParts {
  void operator()(const char*, const std::vector<TimeStepChange>&) const {}
  void operator()(const char*, const std::vector<DivisionRecord>&) const {}
  void operator()(const char*, const std::vector<PolarityRecord>&) const {}
  void operator()(const char*, const std::vector<BirthSize>&) const {}
  void operator()(const char*, const std::vector<SettlingRecord>&) const {}
  void operator()(const char*, const Contacts&) const {}
};

}  // namespace morula
