#pragma once
// A run of a world: the one loop that takes a scene from its start to its end, a failure or a signal.
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loop/observer.h"
#include "loop/progress.h"
#include "simulation/simulation.h"
#include "store/records.h"

namespace morula {

struct RunSetup {
  std::string label = {};  // of the progress line
  bool quiet = true;       // no progress line is shown
  /// The name of a cell, for the text of a failure; empty: cells go by their paths.
  std::function<std::optional<std::string>(const CellPath&)> nameOf = {};
  /// Any exception ends the run as failed, since its records are stored; otherwise only failures of the scene do.
  bool storesRecords = false;
};

class Run {
 public:
  explicit Run(World world, RunSetup setup = {});

  /// Adds an observer, which must outlive the run. Observers are called in the order in which they were added.
  void watch(Observer& observer) { observers_.push_back(&observer); }
  /// Continues a stopped run: the world takes the saved state (checkpoint.h), and all observers resume. Throws
  /// InputError for a state of another scene or version.
  void resume(const std::string& state, const Resumed& earlier);
  /// Continues from the state of another run, whose scene had `added` experiments less, as `resume` does [goOnFrom].
  void goOn(const std::string& state, std::size_t added, const Resumed& earlier);

  /// Steps until the scene ends. A failure of the scene is told in RunEnd::failure, with the names of cells; after a
  /// signal the status is `killed`.
  RunEnd toEnd();
  /// Steps until the scene ends, the clock shows `time` [time] or later, or the count of steps reaches `steps`. A
  /// failure of the scene is told as by toEnd. `stops` is called after every few steps; if it returns true or throws, the
  /// run stops, and may go on later. The status of a run that has not ended is `killed`.
  RunEnd until(double time, std::uint64_t steps, const std::function<bool()>& stops);
  /// Takes at most `most` steps, and no more than observers allow, which then see the world. Returns false, without a
  /// step, if the scene has ended. Throws NumericalError if the physics cannot go on.
  bool advance(std::uint64_t most = neverDue);

  const World& world() const { return world_; }
  /// The world, when the run is over.
  World takeWorld() { return std::move(world_); }
  /// The exception that ended the run if the scene is not to blame for it; null without one.
  std::exception_ptr error() const { return error_; }

 private:
  void see();
  void showResumed(const Resumed& earlier);
  RunEnd stop();
  RunEnd fail(const std::string& why, Want want);

  World world_;
  RunSetup setup_;
  std::vector<Observer*> observers_;
  Progress progress_;
  bool begun_ = false;  // the observers have seen the start
  std::exception_ptr error_;
};

}  // namespace morula
