#pragma once
// The tables of a run, each with the list of its columns, in the order in which people meet them. Only this file knows
// all tables: code that writes, reads, copies, compares, counts or hashes them goes through runTables().
#include <string>
#include <vector>

#include "connections/connections.h"
#include "database/record_table.h"
#include "store/against_tables.h"
#include "store/records.h"
#include "store/seal.h"

namespace morula {

template <>
inline constexpr auto choices<Fate> =
    std::to_array<Choice<Fate>>({{Fate::alive, "alive", ""}, {Fate::divided, "divided", ""}, {Fate::died, "died", ""}});
template <>
inline constexpr auto choices<Scope> =
    std::to_array<Choice<Scope>>({{Scope::world, "world", ""}, {Scope::cell, "cell", ""}, {Scope::pair, "pair", ""}});

/// Texts that decided runs, each stored once however many runs share it.
struct StoredText {
  std::string hash, content;
};
template <>
inline constexpr TableInfo tableInfo<StoredText> = {
    .name = "document",
    .part = TablePart::record,
    .key = "hash",
    .why = "always: the scenario, its files and the program's changes, to repeat the run from"};
template <IsA<StoredText> T>
void listFields(T& text, auto&& field) {
  auto& [hash, content] = text;
  field({"hash"}, hash);
  field({"content"},
        BytesOf{[&]() -> std::string_view { return text.content; }, [&](const auto& bytes) { text.content = bytes; }});
}

struct DocumentUse {
  std::string role, path, hash;
};
template <>
inline constexpr TableInfo tableInfo<DocumentUse> = {.name = "run_document",
                                                     .part = TablePart::record,
                                                     .context = "run_id number",
                                                     .key = "run_id, number",
                                                     .why = "always: which document is what of which run"};
template <IsA<DocumentUse> T>
void listFields(T& use, auto&& field) {
  auto& [role, path, hash] = use;
  field({"role", "scenario (as read), resolved (defaults and overrides filled in), dna, mesh"}, role);
  field({.name = "path", .anyCharacters = true}, path);
  field({.name = "hash", .refersTo = "document"}, hash);
}

template <>
inline constexpr TableInfo tableInfo<StoredRun> = {
    .name = "run",
    .part = TablePart::record,
    .key = "run_id",
    .hasRowNumbers = true,
    .csv = "runs",
    .later = "mother_run_id mother_time",
    .why = "always: which run it is, how it ended, with which program and where"};

struct CellRow {
  LineageEntry cell;
  std::string state;
  std::optional<std::string> name;
};
template <>
inline constexpr TableInfo tableInfo<CellRow> = {
    .name = "cell",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, path",
    .order = "born, path",
    .csv = "cells",
    .why = "always: the lineage; lineage, render, replay and explain read it"};
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

template <>
inline constexpr TableInfo tableInfo<WorldMeasures> = {
    .name = "sample",
    .part = TablePart::samples,
    .context = "run_id",
    .key = "run_id, time",
    .csv = "samples",
    .why = "the organism over time, as often as `record.every` says; replay and queries read it"};
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
template <>
inline constexpr TableInfo tableInfo<CellSampleRow> = {.name = "cell_sample",
                                                       .part = TablePart::samples,
                                                       .context = "run_id time",
                                                       .key = "run_id, time, path",
                                                       .csv = "cell_samples",
                                                       .why = "each cell at the times of `sample`"};
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

template <>
inline constexpr TableInfo tableInfo<ContactMeasures> = {
    .name = "contact",
    .part = TablePart::samples,
    .context = "run_id time",
    .key = "run_id, time, a, b",
    .csv = "contacts",
    .why = "each pair of touching cells at the times of `sample`, in a scene with contact"};
template <IsA<ContactMeasures> T>
void listFields(T& contact, auto&& field) {
  field({"a"}, contact.a);
  field({"b"}, contact.b);
  field({"measures"}, measuresIn(contact, [](const PairMeasure&) { return true; }));
}

template <>
inline constexpr TableInfo tableInfo<TakenMeasure> = {
    .name = "measure",
    .part = TablePart::samples,
    .context = "run_id time",
    .key = "run_id, time, scope, name, a, b",
    .why = "what `record.measures` asks for, at the times of `sample`; replay and queries read it"};
template <IsA<TakenMeasure> T>
void listFields(T& taken, auto&& field) {
  auto& [scope, name, a, b, value] = taken;
  field({"scope"}, scope);
  field({"name", "of scenarios/MEASURES.md"}, name);
  field({"a", "the cell's path, or the pair's first; '' of the world"}, a);
  field({"b", "the pair's second; '' of the world and a cell"}, b);
  field({"value"}, AnyReal{value});
}

template <>
inline constexpr TableInfo tableInfo<CellSurface> = {
    .name = "mesh_sample",
    .part = TablePart::samples,
    .context = "run_id time",
    .key = "run_id, time, path",
    .hasRowNumbers = true,
    .why = "each cell's surface, as often as `record.meshes` says; export and replay read it"};
template <IsA<CellSurface> T>
void listFields(T& surface, auto&& field) {
  auto& [path, mesh, low, step, numbers] = surface;
  const auto bytes = [&] { return numberBytes(surface); };
  field({"path"}, path);
  field({"mesh", "0 the egg's, 1 ... the coarser ones; its faces: the run's document of the role faces and this path"},
        mesh);
  field({"low", "a vertex = low + number * step, off by at most step / 2", "length"}, low);
  field({"step", "a 65535th of the extent", "length"}, step);
  field({"vertices", "the numbers of x, y and z of each vertex, 16 bits each, little-endian"},
        BytesOf{bytes, [&](const auto& text) { surface.numbers = numbersFrom(text); }});
}

template <>
inline constexpr TableInfo tableInfo<ConnectionRecord> = {
    .name = "connection",
    .part = TablePart::end,
    .context = "run_id number",
    .key = "run_id, number",
    .csv = "connections",
    .why = "every connection that was ever made, in a scene with connections"};
template <IsA<ConnectionRecord> T>
void listFields(T& connection, auto&& field) {
  auto& [a, b, made, released, cause] = connection;
  field({"a"}, a);
  field({"b"}, b);
  field({"made", "", "time"}, made);
  field({"released", "NULL while it holds", "time"}, NullIf{released < 0, released});
  field({"cause", "why it was released; '' while it holds"}, cause);
}

template <>
inline constexpr TableInfo tableInfo<DivisionRecord> = {
    .name = "division",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, path",
    .order = "step, path",
    .csv = "divisions",
    .why = "every division: its axis and how the volume was shared"};
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

template <>
inline constexpr TableInfo tableInfo<TimeStepRecord> = {
    .name = "time_step",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, step",
    .csv = "time_steps",
    .why = "in a scene with bodies: the time step and its changes; replay reads it"};
template <IsA<TimeStepRecord> T>
void listFields(T& change, auto&& field) {
  auto& [time, step, timeStep] = change;
  field({"step"}, step);
  field({"time", "", "time"}, time);
  field({"time_step", "in force from here on", "time"}, timeStep);
}

template <>
inline constexpr TableInfo tableInfo<SettlingRecord> = {
    .name = "settling",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, step",
    .csv = "settlings",
    .why = "with physics.integrator fire: how near to equilibrium each settling came, and what it took"};
template <IsA<SettlingRecord> T>
void listFields(T& settling, auto&& field) {
  auto& [time, step, cells, evaluations, residual, energyLeft, displacementLeft] = settling;
  field({"step"}, step);
  field({"time", "of the events before it", "time"}, time);
  field({"cells"}, cells);
  field({"evaluations", "of the forces"}, evaluations);
  field({"residual", "tractions left over the pressure in cells; at most physics.settle.tolerance where it ended"},
        residual);
  field({"energy_left",
         "that cells lose until the residual is a hundredth of the tolerance; of samples (physics.settle.sample)",
         "force·length"},
        energyLeft);
  field({"displacement_left", "the farthest that a vertex goes on that way", "length"}, displacementLeft);
}

template <>
inline constexpr TableInfo tableInfo<ExperimentRecord> = {
    .name = "experiment",
    .part = TablePart::end,
    .context = "run_id number",
    .key = "run_id, number",
    .csv = "experiments",
    .why = "with `experiments`: what was done to which cell, and when"};
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

template <>
inline constexpr TableInfo tableInfo<ChainLink> = {
    .name = "step_hash",
    .part = TablePart::hashes,
    .context = "run_id",
    .key = "run_id, step",
    .why =
        "where the run was checked against a golden or as `check` asks: explain --db and replay find with it the first "
        "step that differs"};
template <IsA<ChainLink> T>
void listFields(T& link, auto&& field) {
  auto& [step, hash, state] = link;
  auto& [whole, clock, cells, connections, lineage] = state;
  field({"step"}, step);
  field({"hash", "a chain: over the row before, the step and the state"}, hash);
  field({"state", "over all parts"}, whole);
  field({"clock"}, clock);
  field({"connections", "zeros where nothing connects"}, connections);
  field({"lineage"}, lineage);
}

template <>
inline constexpr TableInfo tableInfo<CellHash> = {
    .name = "cell_hash",
    .part = TablePart::hashes,
    .context = "run_id step",
    .key = "run_id, step, path",
    .why = "with `step_hash`: explain --db finds with it which cells differ there"};
template <IsA<CellHash> T>
void listFields(T& cell, auto&& field) {
  auto& [path, hash] = cell;
  field({"path"}, path);
  field({"hash", "biology and body"}, hash);
}

template <>
inline constexpr TableInfo tableInfo<CheckResult> = {.name = "check_result",
                                                     .part = TablePart::checks,
                                                     .context = "run_id number",
                                                     .key = "run_id, number",
                                                     .csv = "checks",
                                                     .why = "where the run was checked: what each check found"};

struct BulletSampleRow {
  CellMeasures cell;
  std::string baseline;
};
template <>
inline constexpr TableInfo tableInfo<BulletSampleRow> = {
    .name = "bullet_sample",
    .part = TablePart::bullet,
    .context = "run_id time",
    .key = "run_id, time, path",
    .why = "where `check.bullet` asks for it: each cell in Bullet beside the run's own"};
template <IsA<BulletSampleRow> T>
void listFields(T& row, auto&& field) {
  auto& [cell, baseline] = row;
  field({"path", "as in cell_sample"}, cell.path);
  field({"baseline", "b1 or b3"}, baseline);
  field({"measures"}, measuresIn(cell, [](const CellMeasure& m) { return m.needs == Needs::bodies; }));
}

struct CheckpointRow {
  Checkpoint of;
  std::string made;
};
template <>
inline constexpr TableInfo tableInfo<CheckpointRow> = {
    .name = "checkpoint",
    .part = TablePart::checkpoint,
    .context = "run_id",
    .key = "run_id",
    .hasRowNumbers = true,
    .why = "of runs by morula run, not of a study: run --resume goes on from it, also after the end"};
template <IsA<CheckpointRow> T>
void listFields(T& row, auto&& field) {
  auto& [of, made] = row;
  auto& [step, every, hashEvery, state] = of;
  field({"step", "samples and hashes up to this step are in their tables"}, step);
  field({"made", "UTC"}, made);
  field({"every", "between samples; NULL: none are taken", "time"}, every);
  field({"hash_every", "steps between hashes; NULL: none are taken"}, hashEvery);
  field({"state", "core/state/checkpoint.h"},
        BytesOf{[&]() -> std::string_view { return row.of.state; }, [&](const auto& bytes) { row.of.state = bytes; }});
}

struct FrameRow {
  std::string content;
};
template <>
inline constexpr TableInfo tableInfo<FrameRow> = {
    .name = "checkpoint_frame",
    .part = TablePart::checkpoint,
    .context = "run_id number",
    .key = "run_id, number",
    .hasRowNumbers = true,
    .why = "only until the run has finished: the shapes of its sequence of pictures"};
template <IsA<FrameRow> T>
void listFields(T& frame, auto&& field) {
  static_assert(sizeof frame == sizeof frame.content);
  field({"content"}, BytesOf{[&]() -> std::string_view { return frame.content; },
                             [&](const auto& bytes) { frame.content = bytes; }});
}

/// Returns all tables of a run, in an order in which they can be filled.
const std::vector<const SqlTable*>& runTables();

}  // namespace morula
