#include "system/progress_line.h"

#include <fmt/format.h>

#include <algorithm>

#include "system/console.h"

namespace morula {

using namespace std::chrono_literals;

ProgressLine::ProgressLine(bool quiet)
    : quiet_(quiet), terminal_(isTerminal()), next_(Clock::now() + (terminal_ ? 300ms : 30000ms)) {}

bool ProgressLine::isDue() const { return !quiet_ && Clock::now() >= next_; }

void ProgressLine::show(const std::string& text) {
  showProgress(text);
  shown_ = true;
  next_ = Clock::now() + (terminal_ ? 200ms : 30000ms);
}

void ProgressLine::clear() {
  if (shown_) clearProgress();
  shown_ = false;
}

std::string ProgressLine::bar(double share) const {
  constexpr int width = 24;
  const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * width);
  return (terminal_ ? fmt::format("  [{:=<{}}{:<{}}]", "", full, "", width - full) : "") +
         fmt::format("  {:.0f} %", 100 * share);
}

std::string formatDuration(double seconds) {
  const auto all = static_cast<long long>(std::clamp(seconds, 0.0, 3.6e9) + 0.5);
  const auto hours = all / 3600, minutes = all / 60 % 60, rest = all % 60;
  return hours ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest) : fmt::format("{}:{:02}", minutes, rest);
}

}  // namespace morula
