#include "simulation/stop_when.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "observation/body_measures.h"
#include "observation/measures.h"

namespace morula {
namespace {

/// Returns the time [time] between two looks.
double interval(const StopParameters& stop, const CycleParameters& cycle) {
  constexpr double looksPerCycle = 20;
  return stop.every.value_or(cycle.length / looksPerCycle);
}

bool isIn(const Observation& now, const CellSelection& selection, int cell) {
  const Cells& cells = now.world.cells;
  return selection.has(cells.path[cell], now.world.biology->describe(cells.state[cell]));
}

std::vector<int> cellsIn(const Observation& now, const std::optional<CellSelection>& selection) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(now.world.cells.path.size()); ++i)
    if (!selection || isIn(now, *selection, i)) found.push_back(i);
  return found;
}

bool touch(const Observation& now, const std::vector<int>& ones, const std::vector<int>& others) {
  return std::ranges::any_of(ones, [&](int one) {
    return std::ranges::any_of(now.contactsOf(one), [&](const Observation::Contact& contact) {
      return std::ranges::binary_search(others, contact.cell);
    });
  });
}

/// Returns true if cells live, and the root mean square speed of every cell's vertices is below the bound [length/time].
bool rests(const Bodies& bodies, double bound) {
  for (int i = 0; i < bodies.count; ++i) {
    const double energy = measureKineticEnergy(bodies, bodies.slots[i]), mass = bodies.mass(bodies.slots[i]);
    if (!(2 * energy < bound * bound * mass)) return false;
  }
  return bodies.count > 0;
}

bool isMet(const Observation& now, const StopWhen& when) {
  switch (when.event) {
    case StopEvent::touch: return touch(now, cellsIn(now, when.of[0]), cellsIn(now, when.of[1]));
    case StopEvent::part: {
      const std::vector<int> ones = cellsIn(now, when.of[0]), others = cellsIn(now, when.of[1]);
      return !ones.empty() && !others.empty() && !touch(now, ones, others);
    }
    case StopEvent::born: return !cellsIn(now, when.of[0]).empty();
    case StopEvent::cells:
      return static_cast<double>(cellsIn(now, when.of.empty() ? std::nullopt : std::optional(when.of[0])).size()) >=
             when.count;
    case StopEvent::measure:
      return std::ranges::any_of(takeMeasures(now, {&when.measure, 1}), [&](const TakenMeasure& taken) {
        return (!when.above || taken.value > *when.above) && (!when.below || taken.value < *when.below);
      });
    case StopEvent::rest: return now.world.clock.step > 0 && now.world.bodies && rests(*now.world.bodies, *when.below);
  }
  MORULA_CHECK(false, "every condition can be looked at");
}

}  // namespace

double nextLook(const World& world) {
  const StopParameters& stop = world.model.stop;
  if (stop.when.empty()) return INFINITY;
  const double every = interval(stop, world.model.cycle);
  return (std::floor(world.clock.time / every) + 1) * every;
}

void lookForStop(World& world, const BeforeStep& before) {
  if (world.model.stop.when.empty()) return;
  const double every = interval(world.model.stop, world.model.cycle), time = world.clock.time;
  const bool isDue = std::floor(before.clockTime / every) != std::floor(time / every),
             isEvent = before.nextCycle != world.clock.nextCycle || before.cells != world.cells.path.size();
  if (isDue || isEvent || !world.bodies || world.settlings) lookForStop(world);
}

void lookForStop(World& world) {
  const std::vector<StopWhen>& conditions = world.model.stop.when;
  if (conditions.empty() || world.stoppedBy) return;
  const Observation now(world);
  for (std::size_t i = 0; i < conditions.size() && !world.stoppedBy; ++i)
    if (world.clock.time >= conditions[i].after && isMet(now, conditions[i])) world.stoppedBy = i;
}

}  // namespace morula
