#include "simulation/go_on.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "simulation/restore.h"
#include "simulation/run_end.h"
#include "state/checkpoint_state.h"

namespace morula {
namespace {

/// Returns the largest number of cells that have lived at one time.
std::size_t mostCells(const std::vector<LineageEntry>& entries) {
  std::vector<std::pair<double, int>> changes;  // at one time cells end before others are born
  for (const LineageEntry& e : entries) {
    changes.emplace_back(e.born, 1);
    if (e.fate != Fate::alive) changes.emplace_back(e.ended, -1);
  }
  std::ranges::sort(changes);
  int living = 0, most = 0;
  for (const auto& [time, change] : changes) most = std::max(most, living += change);
  return static_cast<std::size_t>(most);
}

void requireLaterStop(const World& state, const World& world, std::size_t most) {
  const double time = state.clock.time;
  const auto end = plannedEnd(world.model);
  if (end && (world.bodies ? time >= plannedStop(world) : time > *end))
    throw InputError::at("stop", " at time " + exactText(*end) + " is not after time " + numberText(time) +
                                     ", from which the run would go on; give a later one");
  if (const auto& cells = world.model.stop.cells; cells && most >= *cells)
    throw InputError::at("stop.cells", " " + std::to_string(*cells) + ": so many cells lived before time " +
                                           numberText(time) + ", from which the run would go on; give more");
}

/// Returns true unless the experiment, which waits for births, is due after `time` [time] for all cells that it may be
/// for. The substances that a cell had earlier are not known.
bool mayHaveBeenDue(const Experiment& e, const std::vector<LineageEntry>& entries, double time) {
  return std::ranges::any_of(entries, [&](const LineageEntry& entry) {
    const auto mayBe = [&](const CellSelection& s) {
      return s.kind != CellSelection::Kind::cell || s.path == entry.path;
    };
    return entry.born + *e.afterBirth <= time && (e.of.empty() || std::ranges::any_of(e.of, mayBe));
  });
}

void requireLater(const World& state, const Scene& scene, std::size_t added, std::size_t most) {
  const double time = state.clock.time;
  for (std::size_t i = scene.experiments.size() - added; i < scene.experiments.size(); ++i) {
    const Experiment& e = scene.experiments[i];
    const bool isPast = e.at        ? *e.at <= time
                        : e.atCells ? *e.atCells <= most
                                    : mayHaveBeenDue(e, state.lineage.entries, time);
    if (isPast)
      throw InputError::at("experiments[" + std::to_string(i) + "]." + nameOf(e.deed),
                           " is due, or may be, before time " + numberText(time) +
                               ", from which the run would go on; give a later time");
  }
}

}  // namespace

void goOnFrom(World& world, std::string_view checkpoint, std::size_t added) {
  SavedState saved = readCheckpoint(checkpoint, world, added);
  const std::size_t most = mostCells(saved.world.lineage.entries);
  requireLaterStop(saved.world, world, most);
  requireLater(saved.world, world.model, added, most);
  takeState(world, std::move(saved));
}

}  // namespace morula
