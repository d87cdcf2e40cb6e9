#pragma once
// The times at which runs of a scene are compared: evenly spread ones, and some after each event.
#include <cstddef>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/cell_path.h"
#include "state/world.h"

namespace morula {

/// Relative tolerance of a time, which sums of steps may miss by rounding.
inline constexpr double timeSlack = 1e-9;

/// The start of a scene, a birth, a death, or the first contact of two cells. Shapes change fastest there, so errors are
/// largest.
struct SceneEvent {
  double time = 0;      // [time]
  double timeStep = 0;  // [time] the scene's own step at that time
};

/// Finds the events of a run, step by step.
class EventFinder {
 public:
  /// The start of `world` is the first event.
  explicit EventFinder(const World& world);
  /// Must be called after each step.
  void look(const World& world);
  const std::vector<SceneEvent>& events() const { return events_; }  // by time, one per time

 private:
  bool findContacts(const World& world);

  std::size_t born_ = 0, alive_ = 0;
  std::set<std::pair<CellPath, CellPath>> touched_;  // pairs of cells that have touched
  std::vector<SceneEvent> events_;
};

/// Returns true if no event is within 10 steps of the time [time].
bool isQuiet(std::span<const SceneEvent> events, double time);

/// Returns multiples of `step` [time], rising: `samples` evenly spread up to `end`, or all if there are fewer.
std::vector<double> evenTimes(double end, double step, int samples);

/// Sorts times, and leaves one of equals.
void sortTimes(std::vector<double>& times);

/// Returns `even` together with times 1, 4 and 10 steps after each event, rounded up to multiples of `step` [time]. Of
/// up to ten events each step from 1 to 10 counts. Of more than 33, so many are taken, evenly spread. No time is later
/// than the last of `even`.
std::vector<double> withEventTimes(std::vector<double> even, double step, std::span<const SceneEvent> events);

}  // namespace morula
