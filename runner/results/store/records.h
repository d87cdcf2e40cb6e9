#pragma once
// What is stored of a run, as plain data: no simulation and no database is needed to fill or read it.
// The tables are described in store/README.md.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "biology/lineage.h"
#include "division/record.h"
#include "golden/check_result.h"
#include "simulation/hash.h"
#include "simulation/measures.h"
#include "store/build_info.h"
#include "store/cell_surface.h"
#include "store/machine_info.h"

namespace morula {

enum class RunStatus { running, done, failed, killed };
const char* name(RunStatus status);

/// A text that decided the run, byte for byte, so that the run can be repeated from the database alone.
struct SourceText {
  // "scenario" (as read), "resolved" (all defaults and overrides filled in), "dna", "mesh", "shell", "names", "reference", "faces" (of kept surfaces), "diff" (what the
  // program's sources had that their commit had not)
  std::string role;
  std::string path;  // where it was read from; "" if it was not
  std::string content;
  friend bool operator==(const SourceText&, const SourceText&) = default;
};

/// What is known before the first step.
struct RunRecord {
  std::string scenario;      // its name
  std::string scenarioHash;  // semantic: formatting and key order do not count
  std::uint64_t seed = 0;
  std::vector<SourceText> documents;
  std::string command;  // as typed
  std::string isa;      // the kernels' instruction set; changes no result
  int threads = 1;      // changes no result
  BuildInfo build = buildInfo();
  MachineInfo machine = machineInfo();
  std::string binaryHash = morula::binaryHash();
};

/// 16 hexadecimal digits over scenarioHash, seed and build: the same computation has the same id, anywhere.
std::string runId(const RunRecord& record);

/// How the run ended.
struct RunEnd {
  RunStatus status = RunStatus::done;  // done, failed or killed
  std::optional<Hash> stateHash;       // of the final state; required when done
  std::uint64_t steps = 0;
  std::uint64_t cells = 0;    // alive at the end
  double time = 0;            // [time] simulated
  std::string failure;        // what went wrong; "" unless failed
  Want want = Want::nothing;  // what the failure is for want of: then it is compared with nothing
};

/// The state of the organism at one moment, as far as it was measured.
struct Sample {
  WorldMeasures world;
  std::vector<CellMeasures> cells;        // by path; empty in a lineage-only scene
  std::vector<ContactMeasures> contacts;  // by (a, b); empty without contact
  std::vector<TakenMeasure> more{};       // on demand, as the scenario's record asks
  std::vector<CellSurface> surfaces{};    // by path; empty unless they are kept at this time
};

/// A change of the time step; the first entry is the start.
struct TimeStepRecord {
  double time = 0;  // [time]
  std::uint64_t step = 0;
  double timeStep = 0;  // [time] from here on
  friend bool operator==(const TimeStepRecord&, const TimeStepRecord&) = default;
};

/// What a run leaves behind. Every part may be empty: what was not asked for is not stored.
struct RunResults {
  std::vector<LineageEntry> lineage;          // in any order; read back in order of birth
  std::map<StateId, std::string> stateTexts;  // the substances of each state in `lineage`
  std::map<CellPath, std::string> names;      // optional labels of cells
  std::vector<Sample> samples;                // by time
  std::vector<MeshFaces> meshes;              // by number; of those that surfaces in `samples` have
  std::vector<ConnectionRecord> connections;  // in the order in which they were made
  std::vector<TimeStepRecord> timeSteps;
  std::vector<DivisionRecord> divisions;  // of cells with bodies
  std::vector<ChainLink> chain;           // by step
  std::vector<CheckResult> checks;
};

/// Takes samples and hashes, in their order, with the texts of the states and the faces of the meshes in them.
using RecordSink = std::function<void(const RunResults& records)>;

/// What a run that was stopped goes on from. Samples and hashes up to its step stand in their tables.
struct Checkpoint {
  std::uint64_t step = 0;
  std::optional<double> every;             // as RecordOptions
  std::optional<std::uint64_t> hashEvery;  // as RecordOptions
  std::string state;                       // core/simulation/checkpoint.h
};

/// The shapes so far for a sequence of pictures, as bytes: the same run makes the same ones, so those that
/// are stored already are not asked for again.
struct FrameSource {
  std::size_t count = 0;
  std::function<std::string(std::size_t)> bytes;
};

/// A run that goes on.
struct ResumedRun {
  std::string id;
  Checkpoint checkpoint;
  std::vector<std::string> frames;
};

}  // namespace morula
