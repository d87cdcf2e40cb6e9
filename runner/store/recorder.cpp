// The only place where the store meets the simulation.
#include "store/recorder.h"

#include <utility>

#include "simulation/hash.h"
#include "simulation/world.h"

namespace morula {

void Recorder::observe(const World& world) {
  sampled_ = false;
  const Clock& clock = world.clock;
  if (options_.hashEvery && clock.step % *options_.hashEvery == 0) hash(world);
  if (!options_.every || clock.time < static_cast<double>(next_) * *options_.every) return;
  sample(world);
  while (static_cast<double>(next_) * *options_.every <= clock.time) ++next_;
}

void Recorder::hash(const World& world) {
  auto& chain = results_.chain;
  chain.push_back(nextLink(chain.empty() ? std::nullopt : std::optional(chain.back().hash), world));
}

void Recorder::sample(const World& world) {
  results_.samples.push_back({measureWorld(world), measureCells(world), measureContacts(world)});
  sampled_ = true;
}

RunResults Recorder::take(const World& world, bool failed) {
  const bool measuredAlready =
      !results_.samples.empty() && results_.samples.back().world.step == world.clock.step;
  if (options_.every && !failed && !measuredAlready) sample(world);
  if (options_.hashEvery && !failed && results_.chain.back().step != world.clock.step) hash(world);

  RunResults results = std::exchange(results_, {});
  results.lineage = world.lineage.entries;
  if (world.connections) results.connections = world.connections->history;
  for (const TimeStepChange& t : world.timeSteps) results.timeSteps.push_back({t.time, t.step, t.timeStep});

  const auto describe = [&](StateId state) {
    if (const auto [text, isNew] = results.stateTexts.try_emplace(state); isNew)
      text->second = world.biology->describe(state);
  };
  for (const LineageEntry& e : results.lineage) describe(e.state);
  for (const Sample& s : results.samples)
    for (const CellMeasures& c : s.cells) describe(c.state);
  return results;
}

RunEnd endOf(const World& world, RunStatus status, const std::string& failure) {
  RunEnd end{.status = status,
             .stateHash = {},
             .steps = world.clock.step,
             .cells = world.cells.path.size(),
             .time = world.clock.time,
             .failure = failure};
  if (status == RunStatus::done) end.stateHash = stateHash(world);
  return end;
}

}  // namespace morula
