#pragma once
// The tables of a study: `task`, `result` and `timing` stand in the file of one task and in the merged file; `study`,
// `axis`, `level`, `condition`, `condition_key` and `replicate` in the merged file alone. study_store/README.md
// describes their columns.
#include <cstdint>
#include <string>
#include <vector>

#include "base/hash.h"
#include "database/record_table.h"
#include "database/row_digest.h"

namespace morula {

/// The kinds of failure of a task. The row's `reason` begins with the name of the kind, a colon and a blank.
enum class FailureKind { numerical, cpuLimit, memoryLimit, crash };
template <>
inline constexpr auto choices<FailureKind> = std::to_array<Choice<FailureKind>>(
    {{FailureKind::numerical, "numerical failure", "the computation itself failed, as it does on any machine"},
     {FailureKind::cpuLimit, "cpu limit", "the run exceeded its limit of CPU time"},
     {FailureKind::memoryLimit, "memory limit", "the run exceeded its limit of memory, or the machine's memory"},
     {FailureKind::crash, "crash", "the process ended by its own fault"}});
std::string reasonOf(FailureKind kind, const std::string& why);

enum class TaskStatus { done, failed, missing };
template <>
inline constexpr auto choices<TaskStatus> =
    std::to_array<Choice<TaskStatus>>({{TaskStatus::done, "done", "the run came to its end"},
                                       {TaskStatus::failed, "failed", "the run could not continue"},
                                       {TaskStatus::missing, "missing", "the task has not been run"}});

struct TaskRow {
  std::string id;
  std::uint64_t number = 0, condition = 0, seed = 0;  // as in the plan
  TaskStatus status = TaskStatus::missing;
  std::string reason = {};                  // reason of a failure; else ""
  std::string runId = {}, resultHash = {};  // "" while the run is missing

  /// Returns true if the task is done or failed numerically: only scene, seed and program decide these results. Limits
  /// and crashes depend on the machine, too.
  bool isComputed() const;
};
template <>
inline constexpr TableInfo tableInfo<TaskRow> = {.name = "task",
                                                 .part = TablePart::study,
                                                 .key = "task_id",
                                                 .csv = "tasks",
                                                 .why = "of a study: how each run ended; compare and status read it"};
template <IsA<TaskRow> T>
void listFields(T& task, auto&& field) {
  auto& [id, number, condition, seed, status, reason, runId, resultHash] = task;
  field({"task_id", "from the scene's meaning, the seed if used, and the study's measures, when and keep"}, id);
  field({"number", "position in the plan"}, number);
  field({"condition_id", "condition of the first replicate that needs the task"}, condition);
  field({"seed", "seed of that replicate; two's complement from 2^63 on"}, AllBits{seed});
  field({"status"}, status);
  field({.name = "reason",
         .meaning = "'numerical failure: …', 'cpu limit: …', 'memory limit: …', 'crash: …'; '' unless failed",
         .anyCharacters = true},
        reason);
  field({.name = "run_id", .meaning = "NULL while missing", .refersTo = "run"}, NullIf{runId.empty(), runId});
  field({"result_hash", "over all results of the run; NULL while missing"}, NullIf{resultHash.empty(), resultHash});
}

/// One value of one measure of a run: a scalar.
struct ResultRow {
  std::string measure;
  double time = 0;  // [time]
  double value = 0;
  friend bool operator==(const ResultRow&, const ResultRow&) = default;
};
template <>
inline constexpr TableInfo tableInfo<ResultRow> = {
    .name = "result",
    .part = TablePart::study,
    .context = "run_id",
    .key = "run_id, measure, time",
    .csv = "results",
    .why =
        "of a study: the values of `measures`; a measure of cells is the mean over living cells, a measure of pairs "
        "the mean over touching pairs; compare reads it"};
template <IsA<ResultRow> T>
void listFields(T& result, auto&& field) {
  auto& [measure, time, value] = result;
  field({"measure"}, measure);
  field({"time", "the last one is the run's end", "time"}, time);
  field({"value"}, value);
}

/// The time and machine of a task's computation: all that may differ between two computations of the task.
struct TimingRow {
  std::string started, ended;   // UTC
  double cpuSeconds = 0;        // [s]
  std::uint64_t maxMemory = 0;  // [byte]
  std::string host, cpu, kernel, cpuFeatures, fpEnvironment, isa;
  int threads = 1;
  std::string command, binaryHash;
};
template <>
inline constexpr TableInfo tableInfo<TimingRow> = {.name = "timing",
                                                   .part = TablePart::study,
                                                   .context = "task_id",
                                                   .key = "task_id",
                                                   .why = "of a study: when and where each task was computed"};
template <IsA<TimingRow> T>
void listFields(T& timing, auto&& field) {
  auto& [started, ended, cpuSeconds, maxMemory, host, cpu, kernel, cpuFeatures, fpEnvironment, isa, threads, command,
         binaryHash] = timing;
  field({"started", "UTC"}, started);
  field({"ended", "UTC"}, ended);
  field({"cpu_seconds", "", "s"}, cpuSeconds);
  field({"max_memory", "", "byte"}, maxMemory);
  field({"host"}, host);
  field({"cpu"}, cpu);
  field({"kernel"}, kernel);
  field({"cpu_features"}, cpuFeatures);
  field({"fp_environment"}, fpEnvironment);
  field({"isa"}, isa);
  field({"threads"}, threads);
  field({.name = "command", .anyCharacters = true}, command);
  field({"binary_hash"}, binaryHash);
}

// Tables of the merged file alone.

struct StudyRow {
  std::string name, summary, planId, plan, buildId;
};
template <>
inline constexpr TableInfo tableInfo<StudyRow> = {.name = "study",
                                                  .part = TablePart::study,
                                                  .key = "name",
                                                  .hasRowNumbers = true,
                                                  .why = "of a study: what was planned"};
template <IsA<StudyRow> T>
void listFields(T& study, auto&& field) {
  auto& [name, summary, planId, plan, buildId] = study;
  field({"name"}, name);
  field({.name = "summary", .anyCharacters = true}, summary);
  field({"plan_id"}, planId);
  field({.name = "plan", .meaning = "the plan's file without what it predicts", .anyCharacters = true}, plan);
  field({"build_id", "of the program that computed all tasks; '' if there is none yet"}, buildId);
}

struct AxisRow {
  std::uint64_t number = 0;
  std::string name;
};
template <>
inline constexpr TableInfo tableInfo<AxisRow> = {
    .name = "axis", .part = TablePart::study, .key = "number", .why = "of a study: what it varies; compare reads it"};
template <IsA<AxisRow> T>
void listFields(T& axis, auto&& field) {
  auto& [number, name] = axis;
  field({"number", "in the order of the study file"}, number);
  field({"name"}, name);
}

struct LevelRow {
  std::uint64_t axis = 0, number = 0;
  std::string label, keys;
};
template <>
inline constexpr TableInfo tableInfo<LevelRow> = {.name = "level",
                                                  .part = TablePart::study,
                                                  .key = "axis, number",
                                                  .why = "of a study: the values of each axis; compare reads it"};
template <IsA<LevelRow> T>
void listFields(T& level, auto&& field) {
  auto& [axis, number, label, keys] = level;
  field({.name = "axis", .refersTo = "axis"}, axis);
  field({"number", "in the order of the study file"}, number);
  field({.name = "label", .anyCharacters = true}, label);
  field({.name = "keys",
         .meaning = "JSON: the scenario keys that the level sets; null removes a part",
         .anyCharacters = true},
        keys);
}

/// A run that the design asks for. Replicates share a task if they would be equal runs.
struct ReplicateRow {
  std::uint64_t condition = 0, seed = 0;
  std::string task;
};
template <>
inline constexpr TableInfo tableInfo<ReplicateRow> = {
    .name = "replicate",
    .part = TablePart::study,
    .key = "condition_id, seed",
    .csv = "replicates",
    .why = "of a study: the task of each condition and seed; compare reads it"};
template <IsA<ReplicateRow> T>
void listFields(T& replicate, auto&& field) {
  auto& [condition, seed, task] = replicate;
  field({.name = "condition_id", .refersTo = "condition"}, condition);
  field({"seed"}, AllBits{seed});
  field({.name = "task_id", .meaning = "equal replicates share a task", .refersTo = "task"}, task);
}

/// Makes the tables `task`, `result` and `timing`.
void makeTaskTables(Database& db, bool withComments = true);
/// Makes the tables of the merged file. `axes`, `keys`: columns of `condition` and `condition_key`.
void makeStudyTables(Database& db, const std::vector<std::string>& axes, const std::vector<std::string>& keys);

/// Returns all tables of a run and of a study.
const std::vector<const SqlTable*>& allTables();

/// A row of the table `study_digest`: the digest of all rows of a table of the study.
struct StudySeal {
  std::string table;
  RowDigest digest;
};
template <>
inline constexpr TableInfo tableInfo<StudySeal> = {
    .name = "study_digest",
    .part = TablePart::seal,
    .key = "name",
    .why = "of a study: the digests of its own tables; every verb that reads the study compares them"};
template <IsA<StudySeal> T>
void listFields(T& sealed, auto&& field) {
  auto& [table, digest] = sealed;
  auto& [rows, sum] = digest;
  field({"name"}, table);
  field({"rows"}, rows);
  field({"digest", "sum modulo 2^128 of the XXH3-128 of each row"}, sum);
}

/// Stores the digests of the study's own tables. Rows of runs have digests of their own [store/seal.h].
void sealStudy(Database& db);
/// Throws StoreError if the rows of the study's own tables have changed since they were stored.
void requireSealedStudy(Database& db);

/// Returns the hash of the run's end and of all rows of its results. All machines must compute the same hash of a task.
/// NULLs do not count, so that later versions of the tables, with more columns, give equal hashes.
Hash resultHash(Database& db, const std::string& run);

}  // namespace morula
