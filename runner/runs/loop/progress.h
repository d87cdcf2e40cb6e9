#pragma once
// How far a run has come.
#include "system/progress_line.h"

namespace morula {

struct World;

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
  // Where the run was when it was last shown, for the rates.
  Clock::time_point lastShown_;
  double lastTime_ = 0;
  double lastStep_ = 0;
};

}  // namespace morula
