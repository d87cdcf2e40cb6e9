#include "parts/life.h"

#include <algorithm>
#include <set>

#include "simulation/world.h"
#include "system/clock.h"

namespace morula {

namespace {

int deepest(const Cells& cells) {
  int depth = 0;
  for (const CellPath& path : cells.path) depth = std::max(depth, static_cast<int>(path.depth()));
  return depth;
}

}  // namespace

std::uint64_t Life::mostCells() const {
  return std::max_element(eras.begin(), eras.end(),
                          [](const Era& a, const Era& b) { return a.cells < b.cells; })
      ->cells;
}

Life foretellLife(const Scene& scene, std::uint64_t most) {
  Scene genes = scene;
  genes.mechanics.reset();
  World world = makeWorld(genes);
  Life life;
  const int founded = deepest(world.cells);  // start cells have paths, but are no parts of an egg
  life.eras.push_back({0, 0, world.cells.path.size(), 0});
  const auto follow = [&] {
    while (!finished(world)) {
      if (life.cellsAsked >= most) {
        life.whole = false;
        return;
      }
      life.cellsAsked += world.cells.path.size();
      const std::size_t everBefore = world.lineage.entries.size(), before = world.cells.path.size();
      step(world);
      if (world.lineage.entries.size() == everBefore && world.cells.path.size() == before) continue;
      life.eras.back().to = world.clock.time;
      life.eras.push_back({world.clock.time, 0, world.cells.path.size(), deepest(world.cells) - founded});
    }
  };
  life.seconds = timeOf(ClockKind::cpu, follow);
  life.moments = world.clock.step;
  life.divisions = world.lineage.entries.size() / 2;
  std::set<StateId> states;
  for (const LineageEntry& e : world.lineage.entries) states.insert(e.state);
  life.states = states.size();
  // With bodies a run goes on between the cell cycles, unless it has stopped for another reason.
  Era& last = life.eras.back();
  last.to = world.clock.time;
  const bool stopped =
      !life.whole || last.cells == 0 || (scene.stop.cells && last.cells >= *scene.stop.cells);
  if (const auto end = plannedEnd(scene); end && !stopped) last.to = std::max(last.to, *end);
  return life;
}

}  // namespace morula
