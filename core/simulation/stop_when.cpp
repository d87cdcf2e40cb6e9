#include "simulation/stop_when.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "observation/asked_measure.h"
#include "observation/observation.h"

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

/// Returns all values of a measure; of a measure of pairs, those with one of the selected cells at least.
std::vector<double> valuesOf(const Observation& now, const AskedMeasure& asked) {
  std::vector<double> values;
  const auto add = [&](const std::optional<double>& value) {
    if (value) values.push_back(*value);
  };
  const std::vector<int> cells = cellsIn(now, asked.of);
  if (asked.isCount()) return {static_cast<double>(cells.size())};
  if (!canMeasure(now, asked.needs)) return {};
  if (asked.scope == Scope::world) {
    const WorldMeasure& row = measure<Observation>(asked.row);
    add(asked.ofClones && asked.of ? row.ofClones(now, asked.of->generation) : row.get(now));
  } else if (asked.scope == Scope::cell) {
    for (const int cell : cells) add(measure<CellContext>(asked.row).get(now.cell(cell)));
  } else {
    const auto& paths = now.world.cells.path;
    for (const ContactArea& contact : now.contacts()) {
      const bool isMeant = std::ranges::binary_search(cells, contact.a) || std::ranges::binary_search(cells, contact.b);
      if (isMeant && paths[contact.a] < paths[contact.b])
        add(measure<Touch>(asked.row).get({now.cell(contact.a), now.cell(contact.b), contact.area}));
    }
  }
  return values;
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
      return std::ranges::any_of(valuesOf(now, readMeasure(when.measure)), [&](double value) {
        return (!when.above || value > *when.above) && (!when.below || value < *when.below);
      });
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

void lookForStop(World& world, double before, std::size_t born) {
  const StopParameters& stop = world.model.stop;
  if (stop.when.empty() || world.stoppedBy) return;
  const double every = interval(stop, world.model.cycle), time = world.clock.time;
  const bool isDue = std::floor(before / every) != std::floor(time / every);
  if (world.bodies && !world.settlings && !isDue && world.lineage.entries.size() == born && time > 0) return;
  const Observation now(world);
  for (std::size_t i = 0; i < stop.when.size() && !world.stoppedBy; ++i)
    if (time >= stop.when[i].after && isMet(now, stop.when[i])) world.stoppedBy = i;
}

}  // namespace morula
