#include "parts/rehearsal.h"

#include <algorithm>

#include "simulation/stages.h"
#include "system/clock.h"

namespace morula {

Rehearsal rehearse(World world, const Life& life, double vertexSteps) {
  Rehearsal r{.world = std::move(world), .stretches = {{}}};
  World& w = r.world;
  for (double done = 0; done < vertexSteps; done += w.bodies->livingVertices) {
    if (finished(w)) {
      r.whole = true;
      break;
    }
    const std::size_t era = r.stretches.size() - 1;
    const std::size_t ever = w.lineage.entries.size(), cells = w.cells.path.size();
    const std::uint64_t rebuilds = w.contacts ? w.contacts->rebuilds : 0;
    const std::uint64_t pairs = w.contacts ? w.contacts->pairEvaluations : 0;
    const double seconds = timeOf(ClockKind::cpu, [&] { step(w); });
    Stretch& stretch = r.stretches.back();
    ++stretch.steps;
    stretch.until = w.clock.time;
    if (w.contacts) {
      stretch.rebuilds += w.contacts->rebuilds - rebuilds;
      stretch.pairs += w.contacts->pairEvaluations - pairs;
    }
    r.seconds += seconds;
    if (w.lineage.entries.size() == ever && w.cells.path.size() == cells) continue;
    r.upheavalSeconds += seconds;
    r.upheavalCells += w.cells.path.size();
    if (w.bodies->count > 0) r.timeStepLimit = timeStepLimit(w);
    r.generation = life.eras[std::min(era + 1, life.eras.size() - 1)].generation;
    if (era + 1 < life.eras.size()) r.stretches.emplace_back().until = w.clock.time;
  }
  return r;
}

}  // namespace morula
