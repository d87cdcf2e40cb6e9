#pragma once
// The plan of a study, made before anything runs: its conditions, and each distinct run that they need.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/simulation.h"
#include "study/study_file.h"
#include "system/json.h"

namespace morula {

/// One cell of the factorial design. The last axis changes fastest.
struct Condition {
  std::size_t number = 0;           // index in Plan::conditions
  std::vector<std::string> labels;  // one for each axis
  std::vector<std::size_t> levels;  // the labels' numbers in the axes
  std::size_t base = 0;             // index in Study::bases
  /// The scenario, loaded with the first seed and the overrides of the condition's levels. The study's measures and
  /// times replace its `record`. Paths of the scenario's file and in the scenario are relative to the study's folder.
  Scenario scenario;
  bool usesSeed = false;  // other seeds give other results
  /// Hash of the scene except its seed, of the check's reference if measures use it, and of the colours of pictures.
  Hash meaning;
};

/// One distinct run.
struct Task {
  std::string id;  // 16 hex digits, from the condition's meaning, the seed if it is used, measures, `when` and `keep`
  std::size_t condition = 0;  // condition of the first replicate that needs the task
  std::uint64_t seed = 0;     // seed of that replicate
  friend bool operator==(const Task&, const Task&) = default;
};

/// One run that the design asks for. Replicates share a task if their conditions are equal, or if seeds change nothing.
struct Replicate {
  std::size_t condition = 0;
  std::uint64_t seed = 0;
  std::size_t task = 0;  // index in Plan::tasks
  friend bool operator==(const Replicate&, const Replicate&) = default;
};

/// The expected cost of one run of a condition on this machine, with one thread.
struct RunCost {
  double seconds = 0;  // CPU time
  double memory = 0;   // [byte] arrays at the largest number of cells
  double disk = 0;     // [byte] size of the result
  bool tried = false;  // the run's beginning was rehearsed; else estimated from other conditions
  friend bool operator==(const RunCost&, const RunCost&) = default;
};

/// The expected cost of a base's first condition in two ways: with its own integrator, which takes time steps, and with
/// `physics.integrator: quasi-static`, which goes from one state at rest to the next.
struct SettledCost {
  std::size_t base = 0;             // index in Study::bases
  double seconds = 0, settled = 0;  // [s] CPU time with its own integrator, and with quasi-static
  std::string refused;              // why quasi-static is impossible; "" if it is possible
};

struct Plan {
  Study study;  // paths are relative to the study's folder, as in the conditions' scenarios
  std::vector<Condition> conditions;
  std::vector<Task> tasks;            // in the order of the first replicates that need them
  std::vector<Replicate> replicates;  // by condition, then in the order of the seeds
  std::string id;                     // 32 hex digits: hash of all that decides what is run, kept and compared
  std::vector<std::string> warnings;  // warnings of the scenarios; not in the plan's file
  std::vector<RunCost> costs;         // one for each condition; empty: not predicted; not part of the id
  std::vector<SettledCost> settled;   // at most one for each base; not in the plan's file
};

struct PlanOptions {
  bool predict = true;
  double rehearsal = 0.5;  // [s] of CPU time for all predictions together, unless the first one takes longer
  Execution execution = {};
};

/// Throws InputError with all mistakes of all conditions: wrong overrides, measures that a condition cannot have,
/// scenes that cannot be built. Throws FileError if a scenario cannot be read.
Plan makePlan(const Study& study, const PlanOptions& options = {});

/// Returns the condition's scenario with the task's seed, as if it had been loaded with that seed.
Scenario scenarioOf(const Plan& plan, const Task& task);

/// Returns the text of the plan's file: everything that a run of the plan needs, including scenarios and their files.
/// The text ends with a newline. Equal plans give equal texts on every machine, except for the costs.
std::string writePlan(const Plan& plan);
/// Reads a plan from the text of its file. Throws FileError, with the name `file`, if the text is no plan, is damaged,
/// or means something else to this build than to the build that made the plan.
Plan readPlan(const std::string& text, const std::string& file);

/// Returns the conditions, by number, whose results no seed changes.
std::vector<std::size_t> conditionsWithoutSeeds(const Plan& plan);
/// Returns groups of two or more conditions, by number, that are equal and so share their runs.
std::vector<std::vector<std::size_t>> conditionsThatShare(const Plan& plan);
/// Returns "division: longest, connections: none"; "the scenario as it is" without axes.
std::string nameOf(const Plan& plan, std::size_t condition);

/// Returns all tasks' CPU time, the largest task's memory and all tasks' disk. Absent if they were not predicted.
std::optional<RunCost> totalCost(const Plan& plan);

/// Describes a plan before anything starts: counts, shared runs, conditions that seeds do not change, costs.
std::string describe(const Plan& plan);
/// Returns the description for programs: `morula study plan --json`.
Json summaryOf(const Plan& plan);

/// Returns the default folder of a study's results: results/studies/NAME.
std::filesystem::path studyFolder(const Study& study);

/// Returns FOLDER/plan.json.
std::filesystem::path planFile(const std::filesystem::path& folder);

/// Writes the plan into the folder, which it makes. Returns false, and writes nothing, if an equal plan is there.
/// Throws InputError if another plan is there, since its results would be taken for this plan's. Throws FileError if
/// the folder cannot be read or written.
bool keepPlan(const Plan& plan, const std::filesystem::path& folder);

/// Returns the plan of the folder. Throws FileError as readPlan does, or if the folder has no plan.
Plan loadPlan(const std::filesystem::path& folder);

}  // namespace morula
