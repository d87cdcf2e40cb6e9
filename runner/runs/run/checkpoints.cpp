#include "run/checkpoints.h"

#include <algorithm>

#include "base/error.h"
#include "database/store_error.h"
#include "pictures/frame_file.h"
#include "simulation/run_end.h"
#include "simulation/settle.h"
#include "simulation/simulation.h"
#include "state/checkpoint.h"
#include "system/console.h"

namespace morula {

namespace {

// Number of steps between states that are kept in memory because any step may be the last one.
constexpr std::uint64_t stepsBetweenStates = 256;
constexpr std::size_t maxKept = 256 << 20;  // [byte] A larger state would make up most of its database.

bool endsAtAnyStep(const World& world) { return world.model.stop.cells || !world.model.stop.when.empty(); }

}  // namespace

std::uint64_t Checkpoints::stepsUntilDue(const World& world) const {
  std::uint64_t steps = every_ > 0 ? every_ - world.clock.step % every_ : neverDue;
  if (!world.bodies || settles(world)) return 1;
  if (endsAtAnyStep(world)) steps = std::min(steps, stepsBetweenStates - world.clock.step % stepsBetweenStates);
  return std::min(steps, std::max<std::uint64_t>(stepsUntil(world.clock, plannedStop(world)), 2) - 1);
}

void Checkpoints::see(const World& world) {
  if (finished(world)) return;  // the last state depends on the scene's stop, so that no other run could go on from it
  keepBeforeEnd(world);
  if (every_ > 0 && world.clock.step > 0 && world.clock.step % every_ == 0) keep(world);
}

/// The last step to the planned end may be shorter than others, and in the step that reaches a number of cells no
/// further cell divides. So runs with a later stop go on from before that step.
void Checkpoints::keepBeforeEnd(const World& world) {
  const std::size_t born = world.lineage.entries.size();
  if (!world.bodies) {  // a step takes less than keeping the state of many cells
    if (born_ > 0 && born < born_ + born_ / 4) return;
  } else if (!settles(world) && stepsUntil(world.clock, plannedStop(world)) > 1 &&
             !(endsAtAnyStep(world) && (born_ == 0 || world.clock.step % stepsBetweenStates == 0)))
    return;
  try {
    beforeEnd_ = checkpointOf(world);
    if (beforeEnd_->state.size() > maxKept) beforeEnd_.reset();
    born_ = born;
  } catch (const BugError&) {}  // a number is not finite, which the next step tells
}

Checkpoint Checkpoints::checkpointOf(const World& world) const {
  const RecordOptions& recording = samples_.recorder().options();
  return {world.clock.step, recording.every, recording.hashEvery, saveState(world)};
}

void Checkpoints::keep(const World& world) {
  const Recorder& recorder = samples_.recorder();
  try {
    kept_ = store_.keepCheckpoint(id_, checkpointOf(world), recorder.records(),
                                  {frames_.frames().size(), [&](auto i) { return frameBytes(frames_.frames()[i]); }});
  } catch (const BusyError& error) { tell(std::string("no checkpoint was made: ") + error.what(), quiet_); }
}

}  // namespace morula
