#pragma once
// The loop: step until the scene's end, a failure or a signal.
#include <chrono>
#include <exception>
#include <functional>

#include "scenario/scenario.h"
#include "simulation/world.h"
#include "store/recorded_tables.h"
#include "store/recorder.h"
#include "system/console.h"

namespace morula {

struct Simulation {
  World world;
  RunEnd end;          // done, failed or killed
  RunResults results;  // lineage, samples, step hashes, …
  int signal = 0;      // the one that ended it
  // Ended the run, and is neither the scene's nor a lack of memory: thrown once all is stored.
  std::exception_ptr error = {};
  // Records that went elsewhere meanwhile, if a golden asks: hashes, samples without cells, and all of them as a golden
  // holds them.
  RunResults passed = {};
  RecordedTables passedTables = {};
};

/// Builds the scenario's world. InputErrors name the scenario's file.
World makeScenarioWorld(const Scenario& scenario, const Execution& execution);

/// [steps] from one hash of the state to the next, where the states on the way are hashed. Enough to tell at
/// which step two runs part; a hash costs about as much as a step. A lineage is hashed at every step.
constexpr std::uint64_t stepsPerHash = 64;
/// Returns the number of steps between two hashes: 1 in scenes whose steps are cell cycles or settlings.
std::uint64_t stepsPerHashOf(const Scene& scene);

/// Returns true if a checked run hashes the states on the way: for the comparison with a golden, or as `check`
/// asks. `explain --db` looks for the first difference in what is stored of them.
bool wantsHashes(const Scenario& scenario, bool hasGolden);

/// Another way to compute the same: other kernels and another number of threads.
Execution otherExecution(const Execution& how);

/// Makes the part of a run's record that is known before its first step. `command`: as typed.
RunRecord recordOf(const Scenario& scenario, const Execution& execution, const std::string& command);

/// Returns what a run of the scenario records: its samples, and with `hashes` the hashes of states on the way.
RecordOptions recordingOf(const Scenario& scenario, bool hashes);

struct RunOptions {
  std::string label = {};  // of the progress that is shown; "": the scenario's name
  bool quiet = true;       // no progress is shown
  /// Options of recording, beside lineage and names.
  RecordOptions record = {};
  /// Receives records during the run. Without a sink they are kept in memory.
  RecordSink sink = {};
  /// Sees the world at the start and after every step.
  std::function<void(const World&)> watch = {};
  /// The number of steps after which `watch` needs to see the world again, at least 1; without it, every step.
  std::function<std::uint64_t(const World&)> stepsUntilWatch = {};
  /// Keeps what the run can be resumed from: every so many steps (0: never), and when a signal ends the run.
  std::function<void(const World&, const Recorder&)> keep = {};
  std::uint64_t keepEvery = 0;
};

/// Runs the scenario from its beginning to its end. InputErrors name its file. A NumericalError is not thrown but told
/// in `end.failure`, with the names of cells that have one.
Simulation simulate(const Scenario& scenario, const Execution& how, RunOptions options = {});

/// Runs the scenario in a world that is made already.
Simulation simulate(const Scenario& scenario, World world, RunOptions options = {});

/// Any world, and a recorder of one's own. With `resumed`, the recorder, which goes on with a stopped run's records
/// (Recorder::resume), and the watcher have seen it as it is.
Simulation simulate(World world, Recorder recorder, const RunOptions& options, bool resumed = false);

/// Throws what a run failed of if that was for want of something (Want): compared with another one, it would say
/// nothing.
void requireEnough(const RunEnd& end);

/// How far a run has come.
class Progress {
 public:
  Progress(std::string label, bool quiet);

  /// Call after every step; looks at the clock only now and then.
  void show(const World& world);
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::string text(const World& world, double stepsPerSecond, double timePerSecond) const;

  std::string label_;
  ProgressLine line_;
  unsigned calls_ = 0;
  // The state of the run when it was last shown, for rates.
  Clock::time_point lastShown_;
  double lastTime_ = 0;
  double lastStep_ = 0;
};

}  // namespace morula
