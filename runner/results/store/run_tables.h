#pragma once
// The tables of a run, in the order in which people meet them. The columns of rows that a world alone gives are listed
// in core/observation/run_rows.h, those of other rows beside their tables. Only this file knows all tables: code that
// writes, reads, copies, compares, counts or hashes them goes through runTables().
#include <string>
#include <vector>

#include "database/record_table.h"
#include "observation/run_rows.h"
#include "store/against_tables.h"
#include "store/records.h"
#include "store/seal.h"

namespace morula {

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
    .why = "always: which run it is, how it ended, with which program and where"};

template <>
inline constexpr TableInfo tableInfo<CellRow> = {
    .name = "cell",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, path",
    .order = "born, path",
    .csv = "cells",
    .why = "always: the lineage; lineage, render, replay and explain read it"};

template <>
inline constexpr TableInfo tableInfo<WorldMeasures> = {
    .name = "sample",
    .part = TablePart::samples,
    .context = "run_id",
    .key = "run_id, time",
    .csv = "samples",
    .why = "the organism over time, as often as `record.every` says; replay and queries read it"};

template <>
inline constexpr TableInfo tableInfo<CellSampleRow> = {.name = "cell_sample",
                                                       .part = TablePart::samples,
                                                       .context = "run_id time",
                                                       .key = "run_id, time, path",
                                                       .csv = "cell_samples",
                                                       .why = "each cell at the times of `sample`"};

template <>
inline constexpr TableInfo tableInfo<ContactMeasures> = {
    .name = "contact",
    .part = TablePart::samples,
    .context = "run_id time",
    .key = "run_id, time, a, b",
    .csv = "contacts",
    .why = "each pair of touching cells at the times of `sample`, in a scene with contact"};

template <>
inline constexpr TableInfo tableInfo<TakenMeasure> = {
    .name = "measure",
    .part = TablePart::samples,
    .context = "run_id time",
    .key = "run_id, time, scope, name, a, b",
    .why = "what `record.measures` asks for, at the times of `sample`; replay and queries read it"};

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

template <>
inline constexpr TableInfo tableInfo<DivisionRecord> = {
    .name = "division",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, path",
    .order = "step, path",
    .csv = "divisions",
    .why = "every division: its axis and how the volume was shared"};

template <>
inline constexpr TableInfo tableInfo<TimeStepRecord> = {
    .name = "time_step",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, step",
    .csv = "time_steps",
    .why = "in a scene with bodies: the time step and its changes; replay reads it"};

template <>
inline constexpr TableInfo tableInfo<SettlingRecord> = {
    .name = "settling",
    .part = TablePart::end,
    .context = "run_id",
    .key = "run_id, step",
    .csv = "settlings",
    .why = "with physics.integrator quasi-static: how near to rest each settling came, and what it took"};

template <>
inline constexpr TableInfo tableInfo<ExperimentRecord> = {
    .name = "experiment",
    .part = TablePart::end,
    .context = "run_id number",
    .key = "run_id, number",
    .csv = "experiments",
    .why = "with `experiments`: what was done to which cell, and when"};

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
