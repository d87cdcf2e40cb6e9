#include "loop/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/world.h"
#include "system/console.h"

namespace morula {

namespace {

using namespace std::chrono_literals;

constexpr int barWidth = 24;

}  // namespace

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)), quiet_(quiet), terminal_(isTerminal()), lastShown_(Clock::now()) {
  next_ = lastShown_ + (terminal_ ? 300ms : 30000ms);
}

Progress::~Progress() { clear(); }

void Progress::show(const World& world) {
  // A look at the clock costs as much as a small part of the shortest step; 16 steps are shorter than an eye
  // can follow unless they are so long that the look costs nothing.
  if (quiet_ || (++calls_ % 16 != 0 && world.cells.path.size() < 64)) return;
  const auto now = Clock::now();
  if (now < next_) return;
  const double seconds = std::chrono::duration<double>(now - lastShown_).count();
  const auto step = static_cast<double>(world.clock.step);
  const auto text = line(world, (step - lastStep_) / seconds, (world.clock.time - lastTime_) / seconds);
  showProgress(text);
  shown_ = true;
  lastShown_ = now;
  lastTime_ = world.clock.time;
  lastStep_ = step;
  next_ = now + (terminal_ ? 200ms : 30000ms);
}

void Progress::clear() {
  if (shown_) clearProgress();
  shown_ = false;
}

std::string Progress::line(const World& world, double stepsPerSecond, double timePerSecond) const {
  const auto end = plannedEnd(world.model);
  std::string text = label_;
  if (end) {
    const double share = std::clamp(world.clock.time / *end, 0.0, 1.0);
    const int full = static_cast<int>(share * barWidth);
    if (terminal_) text += fmt::format("  [{:=<{}}{:<{}}]", "", full, "", barWidth - full);
    text += fmt::format("  {:.0f} %", 100 * share);
  }
  text += fmt::format("  {} cells", world.cells.path.size());
  if (const auto& most = world.model.stop.cells) text += fmt::format(" of {}", *most);
  text += fmt::format("  time {:.4g}", world.clock.time);
  if (end) text += fmt::format(" of {:.4g}", *end);
  text += fmt::format("  {:.0f} steps/s", stepsPerSecond);
  if (end && timePerSecond > 0)
    text += "  " + formatDuration((*end - world.clock.time) / timePerSecond) + " left";
  return text;
}

std::string formatDuration(double seconds) {
  const auto all = static_cast<long long>(std::clamp(seconds, 0.0, 3.6e9) + 0.5);
  const auto hours = all / 3600, minutes = all / 60 % 60, rest = all % 60;
  return hours ? fmt::format("{}:{:02}:{:02}", hours, minutes, rest) : fmt::format("{}:{:02}", minutes, rest);
}

}  // namespace morula
