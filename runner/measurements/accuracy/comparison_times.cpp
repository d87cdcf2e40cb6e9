#include "accuracy/comparison_times.h"

#include <algorithm>
#include <cmath>

#include "observation/observation.h"

namespace morula {
namespace {

constexpr int quietSteps = 10;                                 // min number of steps between an event and a quiet time
constexpr int stepsAfter[] = {1, 4, 10, 2, 3, 5, 6, 7, 8, 9};  // the first three after every event
constexpr std::size_t maxTimesAfterEvents = 100;

}  // namespace

EventFinder::EventFinder(const World& world) : events_{{world.clock.time, world.clock.timeStep}} {
  born_ = world.lineage.entries.size(), alive_ = world.cells.path.size();
  findContacts(world);
}

void EventFinder::look(const World& world) {
  const std::size_t born = world.lineage.entries.size(), alive = world.cells.path.size();
  const bool changed = born != born_ || alive != alive_, met = findContacts(world);
  born_ = born, alive_ = alive;
  if (changed || met) events_.push_back({world.clock.time, world.clock.timeStep});
}

/// Returns true if two cells touch that have never touched before.
bool EventFinder::findContacts(const World& world) {
  bool met = false;
  const Observation now(world);
  const auto& path = world.cells.path;
  for (const ContactArea& c : now.contacts())
    met = touched_.emplace(path[static_cast<std::size_t>(c.a)], path[static_cast<std::size_t>(c.b)]).second || met;
  return met;
}

bool isQuiet(std::span<const SceneEvent> events, double time) {
  return std::ranges::none_of(events, [&](const SceneEvent& event) {
    return std::abs(time - event.time) <= quietSteps * event.timeStep * (1 + timeSlack);
  });
}

std::vector<double> evenTimes(double end, double step, int samples) {
  const auto steps = static_cast<std::int64_t>(end / step * (1 + 1e-12));
  std::vector<double> times;
  for (int i = 1; i <= samples; ++i) {
    const double time = static_cast<double>(steps * i / samples) * step;
    if (time > (times.empty() ? 0 : times.back())) times.push_back(time);
  }
  return times;
}

void sortTimes(std::vector<double>& times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

std::vector<double> withEventTimes(std::vector<double> even, double step, std::span<const SceneEvent> events) {
  if (even.empty()) return even;
  const double end = even.back();
  const std::size_t count = std::min(events.size(), maxTimesAfterEvents / 3);
  const std::size_t each = std::clamp<std::size_t>(maxTimesAfterEvents / std::max<std::size_t>(count, 1), 3, 10);
  for (std::size_t i = 0; i < count; ++i) {
    const SceneEvent& event = events[i * events.size() / count];
    for (const int after : std::span(stepsAfter).first(each)) {
      const double time = std::ceil((event.time + after * event.timeStep) / step * (1 - timeSlack)) * step;
      if (time <= end) even.push_back(time);
    }
  }
  sortTimes(even);
  return even;
}

}  // namespace morula
