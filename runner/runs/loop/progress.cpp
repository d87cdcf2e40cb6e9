#include "loop/progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/simulation.h"

namespace morula {

Progress::Progress(std::string label, bool quiet) : label_(std::move(label)), line_(quiet), lastShown_(Clock::now()) {}

void Progress::show(const World& world) {
  // A look at the clock costs as much as a small part of the shortest step; 16 steps are shorter than an eye can
  // follow unless they are so long that the look costs nothing.
  if ((++calls_ % 16 != 0 && world.cells.path.size() < 64) || !line_.isDue()) return;
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - lastShown_).count();
  const auto step = static_cast<double>(world.clock.step);
  line_.show(text(world, (step - lastStep_) / seconds, (world.clock.time - lastTime_) / seconds));
  lastShown_ = now;
  lastTime_ = world.clock.time;
  lastStep_ = step;
}

std::string Progress::text(const World& world, double stepsPerSecond, double timePerSecond) const {
  const auto end = plannedEnd(world.model);
  std::string text = label_;
  if (end) text += line_.bar(std::clamp(world.clock.time / *end, 0.0, 1.0));
  text += fmt::format("  {} cells", world.cells.path.size());
  if (const auto& most = world.model.stop.cells) text += fmt::format(" of {}", *most);
  text += fmt::format("  time {:.4g}", world.clock.time);
  if (end) text += fmt::format(" of {:.4g}", *end);
  text += fmt::format("  {:.0f} steps/s", stepsPerSecond);
  if (end && timePerSecond > 0) text += "  " + formatDuration((*end - world.clock.time) / timePerSecond) + " left";
  return text;
}

}  // namespace morula
