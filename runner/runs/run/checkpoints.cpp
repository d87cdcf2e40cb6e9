#include "run/checkpoints.h"

#include "database/store_error.h"
#include "pictures/frame_file.h"
#include "simulation/simulation.h"
#include "state/checkpoint.h"
#include "system/console.h"

namespace morula {

std::uint64_t Checkpoints::stepsUntilDue(const World& world) const {
  return every_ > 0 ? every_ - world.clock.step % every_ : neverDue;
}

void Checkpoints::see(const World& world) {
  if (every_ > 0 && world.clock.step > 0 && world.clock.step % every_ == 0) keep(world);
}

void Checkpoints::keep(const World& world) {
  const Recorder& recorder = samples_.recorder();
  try {
    kept_ = store_.keepCheckpoint(
        id_, {world.clock.step, recorder.options().every, recorder.options().hashEvery, saveState(world)},
        recorder.records(), {frames_.frames().size(), [&](auto i) { return frameBytes(frames_.frames()[i]); }});
  } catch (const BusyError& error) { tell(std::string("no checkpoint was made: ") + error.what(), quiet_); }
}

}  // namespace morula
