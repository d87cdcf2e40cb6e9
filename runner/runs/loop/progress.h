#pragma once
// How far a run has come: a bar on a terminal, otherwise a line every 30 seconds.
#include <chrono>
#include <optional>
#include <string>

namespace morula {
struct World;
}

namespace morula {

class Progress {
 public:
  Progress(std::string label, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call after every step; looks at the clock only now and then.
  void show(const World& world);
  /// Takes the bar away.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  std::string line(const World& world, double stepsPerSecond, double timePerSecond) const;

  std::string label_;
  bool quiet_, terminal_;
  bool shown_ = false;
  unsigned calls_ = 0;
  Clock::time_point next_;  // when to show again
  // Where the run was when it was last shown, for the rates.
  Clock::time_point lastShown_;
  double lastTime_ = 0;
  double lastStep_ = 0;
};

/// "0:42", "1:05:00".
std::string formatDuration(double seconds);

}  // namespace morula
