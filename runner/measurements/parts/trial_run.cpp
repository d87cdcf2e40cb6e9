#include "parts/trial_run.h"

#include <algorithm>

#include "contacts/contacts.h"
#include "simulation/genes_alone.h"
#include "simulation/simulation.h"
#include "simulation/time_step.h"
#include "system/clock.h"

namespace morula {
namespace {

int deepest(const Cells& cells) {
  int depth = 0;
  for (const CellPath& path : cells.path) depth = std::max(depth, static_cast<int>(path.depth()));
  return depth;
}

}  // namespace

std::uint64_t Life::maxCells() const {
  std::uint64_t most = 0;
  for (const Era& era : eras) most = std::max(most, era.cells);
  return most;
}

Life predictLife(const Scene& scene, std::uint64_t most) {
  World world = makeWorld(genesAlone(scene));
  Life life;
  const int founded = deepest(world.cells);  // start cells have paths, but are no divided parts of an egg
  life.eras.push_back({0, 0, world.cells.path.size(), 0});
  life.seconds = timeOf(ClockKind::cpu, [&] {
    while (!finished(world) && (life.whole = life.cellsAsked < most)) {
      life.cellsAsked += world.cells.path.size();
      const std::size_t everBefore = world.lineage.entries.size(), before = world.cells.path.size();
      step(world);
      if (world.lineage.entries.size() == everBefore && world.cells.path.size() == before) continue;
      life.eras.back().to = world.clock.time;
      life.eras.push_back({world.clock.time, 0, world.cells.path.size(), deepest(world.cells) - founded});
    }
  });
  life.moments = world.clock.step;
  life.divisions = world.lineage.entries.size() / 2;
  // With bodies a run continues between cell cycles, unless it has stopped for another reason.
  Era& last = life.eras.back();
  last.to = world.clock.time;
  const bool stopped = !life.whole || last.cells == 0 || (scene.stop.cells && last.cells >= *scene.stop.cells);
  if (const auto end = plannedEnd(scene); end && !stopped) last.to = std::max(last.to, *end);
  return life;
}

TrialRun tryBeginning(World world, const Life& life, double vertexSteps) {
  TrialRun run{.world = std::move(world), .eras = {{}}};
  World& w = run.world;
  for (double done = 0, evaluations = 1; done < vertexSteps; done += evaluations * w.bodies->livingVertices) {
    if ((run.whole = finished(w))) break;
    const std::size_t ever = w.lineage.entries.size(), cells = w.cells.path.size();
    const std::uint64_t searches = w.contacts ? w.contacts->rebuilds : 0;
    const std::uint64_t pairs = w.contacts ? w.contacts->pairEvaluations : 0;
    const std::size_t settlings = w.settlings ? w.settlings->size() : 0;
    const double seconds = timeOf(ClockKind::cpu, [&] { step(w); });
    run.seconds += seconds;
    if (w.settlings && w.settlings->size() > settlings) evaluations = double(w.settlings->back().evaluations);
    // A settling follows its events, of which there may be several.
    while (w.settlings && run.eras.size() < life.eras.size() && life.eras[run.eras.size()].from <= w.clock.time)
      run.eras.emplace_back();
    EraCounts& era = run.eras.back();
    era.steps += evaluations;
    if (w.contacts) {
      era.searches += double(w.contacts->rebuilds - searches);
      era.pairs += double(w.contacts->pairEvaluations - pairs);
    }
    if (w.lineage.entries.size() == ever && w.cells.path.size() == cells) {
      // Fresh cuts spring apart, and contacts are stiff until then.
      if (run.generation > 0 && w.clock.step % 64 == 0 && w.bodies->count > 0 && !w.settlings)
        run.timeStepLimit = std::max(run.timeStepLimit, timeStepLimit(w));
      continue;
    }
    if (w.settlings) run.lastEvaluations = evaluations;
    else run.changeSeconds += seconds, run.changeCells += w.cells.path.size();
    if (w.bodies->count > 0 && !w.settlings) run.timeStepLimit = timeStepLimit(w);
    run.generation = life.eras[std::min(run.eras.size(), life.eras.size() - 1)].generation;
    if (!w.settlings && run.eras.size() < life.eras.size()) run.eras.emplace_back();
  }
  return run;
}

}  // namespace morula
