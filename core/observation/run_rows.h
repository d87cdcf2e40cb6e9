#pragma once
// The rows of the tables that a world gives at any time, each with the list of its columns [base/record.h]: lineage,
// cells, contacts, connections, divisions and others. The database (runner/results/store/run_tables.h), the library
// (library/morula.h) and Python get their columns from these lists.
#include <optional>
#include <string>

#include "biology/lineage.h"
#include "connections/connections.h"
#include "division/division_record.h"
#include "observation/measure_fields.h"
#include "state/experiment_record.h"
#include "state/world.h"

namespace morula {

template <>
inline constexpr auto choices<Fate> =
    std::to_array<Choice<Fate>>({{Fate::alive, "alive", ""}, {Fate::divided, "divided", ""}, {Fate::died, "died", ""}});
template <>
inline constexpr auto choices<Scope> =
    std::to_array<Choice<Scope>>({{Scope::world, "world", ""}, {Scope::cell, "cell", ""}, {Scope::pair, "pair", ""}});

struct CellRow {
  LineageEntry cell;
  std::string state;
  std::optional<std::string> name;
};
template <IsA<CellRow> T>
void listFields(T& row, auto&& field) {
  auto& [cell, state, name] = row;
  auto& [path, born, ended, bornStep, endedStep, fate, number] = cell;
  TextOf mother{[&] { return row.cell.path.mother().text(); }, notRead};
  field({"path", "'' the egg, then A and B"}, path);
  field({"parent", "NULL for the egg"}, NullIf{path.isEgg(), mother});
  field({"born", "", "time"}, born);
  field({"ended", "NULL while alive", "time"}, NullIf{fate == Fate::alive, ended});
  field({"fate"}, fate);
  field({"state", "its last substances, sorted, separated by spaces"}, state);
  field({"name", "what the scenario's names call it"}, name);
  field({"born_step"}, bornStep);
  field({"ended_step"}, NullIf{fate == Fate::alive, endedStep});
}

// Measured numbers are NULL if there was nothing to measure, or if the number was NaN.

inline bool isCells(const WorldMeasure& m) { return std::string_view(m.name) == "cells"; }
template <IsA<WorldMeasures> T>
void listFields(T& sample, auto&& field) {
  field({"time", "", "time"}, sample.time);
  field({"cells"}, measuresIn(sample, isCells));
  field({"step"}, sample.step);
  field({"measures"}, measuresIn(sample, [](const WorldMeasure& m) { return !isCells(m); }));
}

struct CellSampleRow {
  CellMeasures cell;
  std::string state;
};
/// Returns true for measures whose columns come before `state`.
inline bool isOfFirst(const CellMeasure& m) {
  for (const char* name : {"volume", "area", "pressure", "x", "y", "z", "sphericity", "neighbours"})
    if (std::string_view(m.name) == name) return true;
  return false;
}
template <IsA<CellSampleRow> T>
void listFields(T& row, auto&& field) {
  auto& [cell, state] = row;
  field({"path"}, cell.path);
  field({"measures"}, measuresIn(cell, isOfFirst));
  field({"state"}, state);
  field({"measures"}, measuresIn(cell, [](const CellMeasure& m) { return !isOfFirst(m); }));
}

template <IsA<ContactMeasures> T>
void listFields(T& contact, auto&& field) {
  field({"a"}, contact.a);
  field({"b"}, contact.b);
  field({"measures"}, measuresIn(contact, [](const PairMeasure&) { return true; }));
}

template <IsA<TakenMeasure> T>
void listFields(T& taken, auto&& field) {
  auto& [scope, name, a, b, value] = taken;
  field({"scope"}, scope);
  field({"name", "of scenarios/MEASURES.md"}, name);
  field({"a", "the cell's path, or the pair's first; '' of the world"}, a);
  field({"b", "the pair's second; '' of the world and a cell"}, b);
  field({"value"}, AnyReal{value});
}

template <IsA<ConnectionRecord> T>
void listFields(T& connection, auto&& field) {
  auto& [a, b, made, released, cause] = connection;
  field({"a"}, a);
  field({"b"}, b);
  field({"made", "", "time"}, made);
  field({"released", "NULL while it holds", "time"}, NullIf{released < 0, released});
  field({"cause", "why it was released; '' while it holds"}, cause);
}

template <IsA<DivisionRecord> T>
void listFields(T& division, auto&& field) {
  auto& [path, time, step, axis, share, extentRatio, centreA, centreB] = division;
  field({"path", "of the mother"}, path);
  field({"time", "", "time"}, time);
  field({"step"}, step);
  field({"axis", "unit normal of the plane; points to daughter A"}, axis);
  field({"share", "of the mother's volume that daughter A has"}, share);
  field({"extent_ratio", "of the mother's two largest extents; towards 1 it is ambiguous which is the longest"},
        extentRatio);
}

template <IsA<TimeStepChange> T>
void listFields(T& change, auto&& field) {
  auto& [time, step, timeStep] = change;
  field({"step"}, step);
  field({"time", "", "time"}, time);
  field({"time_step", "in force from here on", "time"}, timeStep);
}

template <IsA<SettlingRecord> T>
void listFields(T& settling, auto&& field) {
  auto& [time, step, cells, evaluations, residual, energyLeft, displacementLeft] = settling;
  field({"step"}, step);
  field({"time", "of the events before it", "time"}, time);
  field({"cells"}, cells);
  field({"evaluations", "of the forces"}, evaluations);
  field({"residual", "tractions left over the pressure in cells"}, residual);
  field({"energy_left", "of the motion left", "force·length"}, energyLeft);
  field({"displacement_left", "the farthest that a vertex goes on the way to physics.quasi-static.residual", "length"},
        displacementLeft);
}

template <IsA<ExperimentRecord> T>
void listFields(T& done, auto&& field) {
  auto& [entry, time, step, to, path, other] = done;
  field({"entry", "of the scenario's list, from 1"}, entry);
  field({"time", "", "time"}, time);
  field({"step"}, step);
  field({"done_to"}, to);
  field({"path"}, NullIf{to != DoneTo::cell && to != DoneTo::pair, path});
  field({"other", "the other end of a connection"}, NullIf{to != DoneTo::pair, other});
}

}  // namespace morula
