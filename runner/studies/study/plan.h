#pragma once
// The plan of a study, decided before anything runs: its conditions, and each run that they need once.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/world.h"
#include "study/study_file.h"
#include "system/json.h"

namespace morula {

/// One cell of the factorial design. The last axis changes fastest.
struct Condition {
  std::size_t number = 0;           // in Plan::conditions
  std::vector<std::string> labels;  // one for each axis
  std::vector<std::size_t> levels;  // their numbers in the axes
  std::size_t base = 0;             // in Study::bases
  /// Loaded with the first seed and the overrides of its levels. What `record` said is replaced by what the study
  /// measures and when. Its own file and those that it names are relative to the study's folder.
  Scenario scenario;
  bool usesSeed = false;  // other seeds give other results
  Hash meaning;           // of all that decides results but the seed, and what its measures compare with
};

/// One distinct run.
struct Task {
  std::string id;  // 16 hex digits: of the condition's meaning, the seed if it is used, measures, when and keep
  std::size_t condition = 0;  // of the first replicate that needs it
  std::uint64_t seed = 0;     // of that replicate
  friend bool operator==(const Task&, const Task&) = default;
};

/// One run that the design asks for. Several may share a task: conditions that mean the same, seeds that change
/// nothing.
struct Replicate {
  std::size_t condition = 0;
  std::uint64_t seed = 0;
  std::size_t task = 0;  // in Plan::tasks
  friend bool operator==(const Replicate&, const Replicate&) = default;
};

/// The expected cost of one run of a condition on this machine, with one thread.
struct RunCost {
  double seconds = 0;  // of CPU time
  double memory = 0;   // [byte] of arrays at the largest number of cells
  double disk = 0;     // [byte] of its result
  bool tried = false;  // its beginning was rehearsed; otherwise estimated from conditions that were
  friend bool operator==(const RunCost&, const RunCost&) = default;
};

/// The cost of the first condition of a base that goes through time if it went from rest to rest, with
/// physics.integrator fire.
struct SettledCost {
  std::size_t base = 0;             // in Study::bases
  double seconds = 0, settled = 0;  // [s] of CPU time as it is, and so
  std::string refused;              // why it does not go; "": it does
};

struct Plan {
  Study study;  // its places, and those of the conditions' scenarios, are relative to its folder
  std::vector<Condition> conditions;
  std::vector<Task> tasks;            // in the order of the replicates that need them first
  std::vector<Replicate> replicates;  // by condition, then in the order of the seeds
  std::string id;                     // 32 hex digits: of all that decides what is run, kept and compared
  std::vector<std::string> warnings;  // of the scenarios: what works, but may not be meant. No part of the file.
  std::vector<RunCost> costs;         // one for each condition; empty: not predicted. No part of the id.
  std::vector<SettledCost> settled;   // at most one for each base. No part of the file.
};

struct PlanOptions {
  bool predict = true;
  double rehearsal = 0.5;  // [s] of CPU time for all predictions together, unless the first one takes longer
  Execution execution = {};
};

/// Throws InputError with all mistakes of all conditions: wrong overrides, measures that a condition cannot take,
/// scenes that cannot be built. Throws FileError if a scenario cannot be read.
Plan makePlan(const Study& study, const PlanOptions& options = {});

/// The condition's scenario with the task's seed, as if it had been loaded with it.
Scenario scenarioOf(const Plan& plan, const Task& task);

/// The plan as a file: everything that running it needs, scenarios and the files that they name among it. Ends with a
/// newline. The same plan gives the same text on every machine, but for the costs.
std::string writePlan(const Plan& plan);
/// Reads a plan from its text alone. Throws FileError, which calls it `file`, if it is no plan, is damaged, or
/// means something else to this build than to the one that made it.
Plan readPlan(const std::string& text, const std::string& file);

/// The conditions whose seeds change nothing, by number.
std::vector<std::size_t> conditionsWithoutSeeds(const Plan& plan);
/// Groups of conditions that mean the same and so share their runs, each of two or more, by number.
std::vector<std::vector<std::size_t>> conditionsThatShare(const Plan& plan);
/// "division: longest, connections: none"; "the scenario as it is" without axes.
std::string nameOf(const Plan& plan, std::size_t condition);

/// All tasks' CPU time, the largest task's memory, all tasks' disk. Absent if it was not predicted.
std::optional<RunCost> totalCost(const Plan& plan);

/// Describes a plan before anything starts: counts, shared runs, conditions that seeds do not change, costs.
std::string describe(const Plan& plan);
/// Writes the description for programs: `morula study plan --json`.
Json summaryOf(const Plan& plan);

/// Returns the folder of a study's results unless told otherwise: results/studies/NAME.
std::filesystem::path studyFolder(const Study& study);

/// FOLDER/plan.json.
std::filesystem::path planFile(const std::filesystem::path& folder);

/// Writes the plan into the folder, which is made; false if the same plan is there already, which stays as it is.
/// Throws InputError if another plan is there: what was computed by it would be taken for this one's. Throws FileError.
bool keepPlan(const Plan& plan, const std::filesystem::path& folder);

/// The plan of the folder. Throws FileError as readPlan, and if there is none.
Plan loadPlan(const std::filesystem::path& folder);

}  // namespace morula
