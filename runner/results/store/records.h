#pragma once
// The records of a run, as plain data: filling and reading them needs no simulation and no database. The tables are
// described in store/README.md.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "base/error.h"
#include "base/record.h"
#include "biology/lineage.h"
#include "division/division_record.h"
#include "golden/check_result.h"
#include "observation/measures.h"
#include "state/state_hash.h"
#include "store/build_info.h"
#include "store/cell_surface.h"
#include "store/machine_info.h"

namespace morula {

enum class RunStatus { running, done, failed, killed };
template <>
inline constexpr auto choices<RunStatus> = std::to_array<Choice<RunStatus>>({{RunStatus::running, "running", ""},
                                                                             {RunStatus::done, "done", ""},
                                                                             {RunStatus::failed, "failed", ""},
                                                                             {RunStatus::killed, "killed", ""}});
inline const char* name(RunStatus status) { return nameOf(status); }

/// A text that decided the run, byte for byte, so that the run can be repeated from the database alone.
struct SourceText {
  // "scenario" (as read), "resolved" (all defaults and overrides filled in), "dna", "mesh", "shell", "cells", "names",
  // "reference", "faces" (of kept surfaces), "diff" (of the program's sources from their commit)
  std::string role;
  std::string path;  // the path it was read from; "" if it was not read from a file
  std::string content;
  friend bool operator==(const SourceText&, const SourceText&) = default;
};

/// The part of a run's record that is known before the first step.
struct RunRecord {
  std::string scenario;       // its name
  std::string scenarioHash;   // semantic: formatting and key order do not count
  std::string referenceHash;  // of the reference that measures compare with; "" without check.reference
  std::uint64_t seed = 0;
  std::vector<SourceText> documents;
  std::string command;  // as typed
  std::string isa;      // the kernels' instruction set; changes no result
  int threads = 1;      // changes no result
  BuildInfo build = buildInfo();
  MachineInfo machine = machineInfo();
  std::string binaryHash = morula::binaryHash();
  std::string mother = {};                // id of the run that this one went on from; "" if none
  std::optional<double> motherTime = {};  // [time] of the mother, from which on the two may differ
};

/// Returns 16 hexadecimal digits over scenarioHash, referenceHash, seed and build. The same computation has the same id
/// anywhere.
std::string runId(const RunRecord& record);

/// The end of a run.
struct RunEnd {
  RunStatus status = RunStatus::done;  // done, failed or killed
  std::optional<Hash> stateHash = {};  // of the final state; required when done
  std::uint64_t steps = 0;
  std::uint64_t cells = 0;    // alive at the end
  double time = 0;            // [time] simulated
  std::string failure = {};   // what went wrong; "" unless failed
  Want want = Want::nothing;  // the resource that ran out; such a failure is not compared
};

/// A run stored in a file.
struct StoredRun {
  std::string id = {};
  RunRecord record;  // its documents are left out: see Store::documents
  RunStatus status = RunStatus::running;
  std::string started = {}, ended = {};  // UTC; ended is "" while running
  std::string stateHash = {};            // "" unless done
  std::uint64_t steps = 0, cells = 0;    // 0 while running
  double time = 0;                       // [time]
  std::string failure = {};
  std::optional<std::uint64_t> condition = {};
};

/// The subject of a run's field.
enum class RunPart {
  result,       // decided by the computation
  scene,        // the computed scene
  program,      // the program; it must be assumed that another program gives another result
  detail,       // details of the program
  environment,  // the machine
  occasion,     // time and command of the run
};
struct RunField : FieldInfo {
  RunPart part;
  const char* label;            // for people
  bool changesNothing = false;  // true for a field that changes no result, which tests ensure
};

template <IsA<StoredRun> T>
void listFields(T& run, auto&& field) {
  auto& [id, record, status, started, ended, stateHash, steps, cells, time, failure, condition] = run;
  auto& [scenario, scenarioHash, referenceHash, seed, documents, command, isa, threads, build, machine, binaryHash,
         mother, motherTime] = record;
  auto& [version, sources, gitCommit, gitState, compiler, flags, target, libraries] = build;
  auto& [cpu, kernel, features, fpEnvironment] = machine;
  TextOf buildIdText{[&] { return buildId(run.record.build); }, notRead};
  TextOf librariesList{[&] { return librariesText(run.record.build); },
                       [&](const auto& text) { run.record.build.libraries = librariesFrom(text); }};
  const bool runs = status == RunStatus::running;
  using enum RunPart;
  field(RunField{{"run_id", "from scenario_hash, reference_hash, seed and build_id: the same computation, the same id"},
                 result,
                 "run"},
        id);
  field(RunField{{"scenario"}, result, "scenario"}, scenario);
  field(RunField{{"seed", "two's complement from 2^63 on"}, scene, "seed"}, AllBits{seed});
  field(RunField{{"status"}, result, "status"}, status);
  field(RunField{{"state_hash", "of the final state, all bits; NULL unless done"}, result, "end state"},
        NullIf{stateHash.empty(), stateHash});
  field(RunField{{"started", "UTC"}, occasion, "started"}, started);
  field(RunField{{"ended", "NULL while running"}, occasion, "ended"}, NullIf{ended.empty(), ended});
  field(RunField{{"steps"}, result, "steps"}, NullIf{runs, steps});
  field(RunField{{"cells", "alive at the end"}, result, "cells"}, NullIf{runs, cells});
  field(RunField{{"time", "simulated", "time"}, result, "time"}, NullIf{runs, time});
  field(RunField{{"failure", "why a failed run stopped"}, result, "failure"}, NullIf{failure.empty(), failure});
  field(
      RunField{
          {"scenario_hash", "of the meaning: formatting and key order do not count"}, scene, "meaning of the scenario"},
      scenarioHash);
  field(
      RunField{{"reference_hash", "of check.reference, which measures compare with; NULL without"}, scene, "reference"},
      NullIf{referenceHash.empty(), referenceHash});
  field(RunField{{"build_id", "from sources, compiler, flags, target and libraries"}, detail, "build id"}, buildIdText);
  field(RunField{{"version"}, detail, "version"}, version);
  field(RunField{{"sources", "digest of the program's sources"}, program, "sources"}, sources);
  field(RunField{{"git_commit"}, detail, "commit"}, gitCommit);
  field(RunField{{.name = "git_state", .oneOf = "clean modified unknown"}, detail, "tree"}, gitState);
  field(RunField{{"compiler"}, program, "compiler"}, compiler);
  field(RunField{{"flags"}, program, "flags"}, flags);
  field(RunField{{"target"}, program, "target"}, target);
  field(RunField{{"libraries", "'Eigen 3.4.0; SQLite 3.40.1'"}, program, "libraries"}, librariesList);
  field(RunField{{"cpu"}, environment, "processor"}, cpu);
  field(RunField{{"kernel"}, environment, "kernel"}, kernel);
  field(RunField{{"isa", "changes no result"}, environment, "instruction set", true}, isa);
  field(RunField{{"threads", "changes no result"}, environment, "threads", true}, threads);
  field(RunField{{.name = "command", .meaning = "as typed", .anyCharacters = true}, occasion, "command"}, command);
  field(RunField{{"binary_hash", "XXH3-128 of the program's file"}, detail, "binary hash"}, binaryHash);
  field(RunField{{"mother_run_id", "the run that this one went on from; NULL: none, it began at its start"},
                 occasion,
                 "went on from run"},
        NullIf{mother.empty(), mother});
  field(RunField{{"mother_time", "from which on the two may differ", "time"}, occasion, "went on at time"}, motherTime);
  field(RunField{{"fp_environment", "how the processor rounds, and what it does with denormals"},
                 environment,
                 "floating point"},
        fpEnvironment);
  field(RunField{{"cpu_features", "those that arithmetic can hang on"}, environment, "processor features"}, features);
  field(RunField{{"condition_id", "of a study's merged database; NULL elsewhere"}, occasion, "condition"}, condition);
}

/// Returns the field's label with a capital.
std::string headingOf(const RunField& field);
/// Returns the subject of a column of `run`.
RunPart partOf(const std::string& column);
/// Calls visit(field, value for people) for each field; an absent value is "".
void eachFieldOf(const StoredRun& run, const std::function<void(const RunField&, const std::string&)>& visit);

/// One field of two records side by side.
struct Item {
  std::string name, label;  // name of the column; its label for people
  std::string before, now;
};
/// Compares the parts of a run_id: scenario, reference, seed and the program's sources.
std::vector<Item> compareIdentity(const RunRecord& before, const RunRecord& now);
/// Compares the parts of a run_id and all other known conditions of the two runs.
std::vector<Item> compareConditions(const RunRecord& before, const RunRecord& now);

/// The measured state of the organism at one moment.
struct Sample {
  WorldMeasures world;
  std::vector<CellMeasures> cells;        // by path; empty in a lineage-only scene
  std::vector<ContactMeasures> contacts;  // by (a, b); empty without contact
  std::vector<TakenMeasure> more{};       // measures on demand that the scenario's record asks for
  std::vector<CellSurface> surfaces{};    // by path; empty unless they are kept at this time
};

using TimeStepRecord = TimeStepChange;

/// The side of a comparison with measured cells that has a cell.
enum class FoundIn { both, run, table };

/// A cell of a stage that is compared with measured cells.
struct AgainstCell {
  std::uint64_t stage = 0;  // among RunResults::against
  CellPath path;
  FoundIn in = FoundIn::both;
  std::optional<double> distance;  // [length] of the centre from the measured place; absent unless compared
};

/// Sorts cells by distance, the farthest first, those without one last; equally far ones by path.
void sortByDistance(std::vector<AgainstCell>& cells);

/// A stage of a table of measured cells, compared with the run [runs/check/against.h].
struct AgainstStage {
  std::optional<std::uint64_t> ofCells;     // the table's stage: a number of cells
  std::optional<double> ofTime;             // or [time]
  std::optional<double> time;               // [time] of the run's state; absent: there was none
  std::uint64_t cells = 0;                  // alive then
  std::uint64_t compared = 0;               // of which the table has places
  std::optional<double> rmsd;               // [length] as Superposition::distance; absent: nothing was compared
  std::optional<double> shapeRmsd, scale;   // [1] as Superposition
  std::optional<double> mirroredShapeRmsd;  // [1] of the cells' mirror image
  std::optional<double> contactF1;          // [1] as the measure contact_f1; absent if the table lists no contacts
  std::string why;                          // the reason why nothing was compared
  std::vector<AgainstCell> byCell;          // by distance, the farthest first
};

/// The results of a run. Every part may be empty: only what was asked for is stored.
struct RunResults {
  std::vector<LineageEntry> lineage;          // in any order; read back in order of birth
  std::map<StateId, std::string> stateTexts;  // the substances of each state in `lineage`
  std::map<CellPath, std::string> names;      // optional labels of cells
  std::vector<Sample> samples;                // by time
  std::vector<MeshFaces> meshes;              // meshes of the surfaces in `samples`, by number
  std::vector<ConnectionRecord> connections;  // in the order of their creation
  std::vector<TimeStepRecord> timeSteps;
  std::vector<SettlingRecord> settlings;      // of quasi-static scenes
  std::vector<ExperimentRecord> experiments;  // what was done
  std::vector<DivisionRecord> divisions;      // of cells with bodies
  std::vector<ChainLink> chain;               // by step
  std::vector<CheckResult> checks;
  std::vector<AgainstStage> against;  // the run compared with measured cells
};

/// Receives samples and hashes, in their order, with the texts of the states and the faces of the meshes in them.
using RecordSink = std::function<void(const RunResults& records)>;

/// The state from which a stopped run is resumed. Samples and hashes up to its step are in their tables.
struct Checkpoint {
  std::uint64_t step = 0;
  std::optional<double> every;             // as RecordOptions
  std::optional<std::uint64_t> hashEvery;  // as RecordOptions
  std::string state;                       // the world's bytes [core/state/checkpoint.h]
};

/// The shapes so far for a sequence of pictures, as bytes. The same run makes the same shapes, so stored ones are not
/// requested again.
struct FrameSource {
  std::size_t count = 0;
  std::function<std::string(std::size_t)> bytes;
};

/// A resumed run.
struct ResumedRun {
  std::string id;
  Checkpoint checkpoint;
  std::vector<std::string> frames;
};

}  // namespace morula
