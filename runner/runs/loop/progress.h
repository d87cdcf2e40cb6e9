#pragma once
// The line on stderr that shows how far a run has come.
#include <chrono>
#include <string>

#include "system/console.h"

namespace morula {

struct World;

class Progress {
 public:
  Progress(std::string label, bool quiet);

  /// Called after every batch of steps; looks at the clock only now and then.
  void show(const World& world);

 private:
  using Clock = std::chrono::steady_clock;
  std::string text(const World& world, double stepsPerSecond, double timePerSecond) const;

  std::string label_;
  ProgressLine line_;
  unsigned calls_ = 0;
  // The state of the run when the line was last shown, for rates
  Clock::time_point lastShown_;
  double lastTime_ = 0;
  double lastStep_ = 0;
};

}  // namespace morula
