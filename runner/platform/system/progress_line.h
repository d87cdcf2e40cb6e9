#pragma once
// How far something has come: a line that is rewritten on a terminal, otherwise a line every 30 seconds.
#include <chrono>
#include <string>

namespace morula {

class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether it is time to show something; looks at the clock.
  bool isDue() const;
  void show(const std::string& text);
  void clear();
  /// "  [====    ]  42 %" of a share from 0 to 1; the bar only on a terminal.
  std::string bar(double share) const;

 private:
  using Clock = std::chrono::steady_clock;
  bool quiet_, terminal_, shown_ = false;
  Clock::time_point next_;
};

/// [s] "0:42", "1:05:00".
std::string formatDuration(double seconds);

}  // namespace morula
