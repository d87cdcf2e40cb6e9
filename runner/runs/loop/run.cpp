#include "loop/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "base/error.h"
#include "diagnose/diagnose.h"
#include "simulation/go_on.h"
#include "simulation/memory.h"
#include "simulation/restore.h"
#include "simulation/settle.h"
#include "store/recorder.h"
#include "system/console.h"
#include "system/signals.h"
#include "system/usable_memory.h"
#include "values/cell_names.h"

namespace morula {
namespace {

// Max number of steps between checks for signals and updates of the progress line.
constexpr std::uint64_t maxStepsAtOnce = 64;

}  // namespace

Run::Run(World world, RunSetup setup)
    : world_(std::move(world)), setup_(std::move(setup)), progress_(setup_.label, setup_.quiet) {}

void Run::resume(const std::string& state, const Resumed& earlier) {
  restoreState(world_, state);
  showResumed(earlier);
}

void Run::goOn(const std::string& state, std::size_t added, const Resumed& earlier) {
  goOnFrom(world_, state, added);
  showResumed(earlier);
}

void Run::showResumed(const Resumed& earlier) {
  for (Observer* observer : observers_) observer->resume(world_, earlier);
  begun_ = true;
}

void Run::see() {
  for (Observer* observer : observers_) observer->see(world_);
  progress_.show(world_);
}

bool Run::advance(std::uint64_t most) {
  if (!std::exchange(begun_, true)) see();
  if (finished(world_)) return false;
  std::uint64_t steps = std::min(most, maxStepsAtOnce);
  for (const Observer* observer : observers_) steps = std::min(steps, observer->stepsUntilDue(world_));
  takeSteps(world_, steps);
  see();
  return true;
}

RunEnd Run::stop() {
  for (Observer* observer : observers_) observer->interrupted(world_);
  return endOf(world_, RunStatus::killed);
}

RunEnd Run::fail(const std::string& why, Want want) {
  return endOf(world_, RunStatus::failed, withNames(why, setup_.nameOf), want);
}

RunEnd Run::toEnd() {
  const SignalWatch signals;
  return until(std::numeric_limits<double>::infinity(), neverDue, SignalWatch::caught);
}

RunEnd Run::until(double time, std::uint64_t steps, const std::function<bool()>& stops) {
  const Clock& clock = world_.clock;
  const auto stepsLeft = [&] {
    return clock.step < steps && clock.time < time ? std::min(steps - clock.step, stepsUntil(clock, time)) : 0;
  };
  try {
    if (!std::exchange(begun_, true)) see();
    while (stepsLeft() && advance(stepsLeft()))
      if (stops() && !finished(world_)) return stop();
    if (!finished(world_)) return endOf(world_, RunStatus::killed);
    return endOf(world_, RunStatus::done);  // hashes the state; throws NumericalError if a number is not finite
  } catch (const BodyFailure& error) {
    // `diagnose` finds the force that drove a cell over the last time steps; settling has no time steps.
    return fail(settles(world_) ? error.what() : diagnose(world_.model, world_.execution, error), error.want);
  } catch (const NumericalError& error) { return fail(error.what(), error.want); } catch (const std::bad_alloc&) {
    return fail(fmt::format("step {}: there is no more memory; {}", world_.clock.step, outOfMemoryRemedy),
                Want::memory);
  } catch (const InputError& error) { return fail(error.what(), error.want); } catch (const FileError& error) {
    if (!setup_.storesRecords) throw;
    error_ = std::current_exception();
    return fail(error.what(), Want::files);
  } catch (const std::exception& error) {
    if (!setup_.storesRecords) throw;
    error_ = std::current_exception();
    return fail(std::string("a bug of Morula's: ") + error.what(), Want::reason);
  }
}

}  // namespace morula
