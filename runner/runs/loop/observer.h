#pragma once
// Observers look at a run's world while the run goes on: samples, frames, checks, checkpoints, progress.
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "store/records.h"

namespace morula {

struct World;

/// An observer that only looks at the start, at the end, or when another observer is due, waits for so many steps.
inline constexpr std::uint64_t neverDue = std::numeric_limits<std::uint64_t>::max();

/// The records of a stopped run, from which its observers go on.
struct Resumed {
  std::function<void(const RecordSink&)> eachRecord;  // passes on samples and hashes, in parts
  std::vector<std::string> frames;                    // of the sequence of pictures (frame_file.h)
};

class Observer {
 public:
  virtual ~Observer() = default;
  /// Sees the world at the start of the run, when due, and whenever another observer is due.
  virtual void see(const World& world) = 0;
  /// The number of steps, at least 1, after which the observer has to see the world again.
  virtual std::uint64_t stepsUntilDue(const World&) const { return 1; }
  /// Replaces `see` at the start of a run that goes on from a checkpoint, whose state `world` has.
  virtual void resume(const World&, const Resumed&) {}
  /// A signal ends the run in this state.
  virtual void interrupted(const World&) {}
};

}  // namespace morula
