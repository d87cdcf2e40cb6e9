// The only place where the store meets the simulation.
#include "store/recorder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/multiples.h"
#include "simulation/hash.h"
#include "simulation/world.h"

namespace morula {

void Recorder::observe(const World& world) {
  sampled_ = false;
  const Clock& clock = world.clock;
  if (options_.hashEvery && clock.step % *options_.hashEvery == 0) hash(world);
  const bool reached = reaches(world.cells.path.size()), due = isDue(clock.time);
  if (!divided(world) && !reached && !due) return;
  sample(world);
  if (due) expectNext(clock.time);
}

std::uint64_t Recorder::stepsUntilDue(const World& world) const {
  const Clock& clock = world.clock;
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  if (options_.hashEvery) steps = *options_.hashEvery - clock.step % *options_.hashEvery;
  if (options_.every && world.bodies)
    steps = std::min(steps, stepsUntil(clock, static_cast<double>(next_) * *options_.every));
  return steps;
}

bool Recorder::isDue(double time) const {
  return options_.every ? time >= static_cast<double>(next_) * *options_.every : next_ == 0;
}

void Recorder::expectNext(double time) {
  next_ = options_.every ? firstMultipleAfter(time, *options_.every) : 1;
}

bool Recorder::reaches(std::uint64_t cells) {
  const std::size_t before = reached_;
  while (reached_ < options_.atCells.size() && cells >= options_.atCells[reached_]) ++reached_;
  return reached_ > before;
}

bool Recorder::divided(const World& world) {
  if (!options_.atDivisions) return false;
  // A division adds both daughters to the lineage.
  return std::exchange(divisions_, world.lineage.entries.size()) < world.lineage.entries.size();
}

void Recorder::resume(const World& world, const RunResults& earlier) {
  std::map<StateId, StateId> here;
  for (const auto& [state, text] : earlier.stateTexts) here[state] = world.biology->stateOf(text);
  for (Sample s : earlier.samples) {
    if (s.world.step > world.clock.step || s.world.time > world.clock.time) continue;
    const bool reached = reaches(static_cast<std::uint64_t>(s.world.at("cells"))), due = isDue(s.world.time);
    if (!reached && !due && !options_.atDivisions) continue;
    for (CellMeasures& c : s.cells) describe(world, c.state = here.at(c.state));
    keepTouching(s.contacts, s.world.time);
    if (due) expectNext(s.world.time);
    results_.samples.push_back(std::move(s));
  }
  for (const ChainLink& link : earlier.chain)
    if (options_.hashEvery && link.step <= world.clock.step && link.step % *options_.hashEvery == 0)
      results_.chain.push_back(link);
}

void Recorder::hash(const World& world) {
  auto& chain = results_.chain;
  chain.push_back(nextLink(chain.empty() ? std::nullopt : std::optional(chain.back().hash), world));
  bytes_ += double(sizeof(ChainLink) + chain.back().state.cells.size() * sizeof(CellHash));
}

void Recorder::keepTouching(const std::vector<ContactMeasures>& contacts, double time) {
  if (std::ranges::find(options_.measures, "contact_duration") == options_.measures.end()) return;
  const auto before = std::exchange(touchingSince_, {});
  for (const ContactMeasures& c : contacts) {
    const std::pair pair(c.a, c.b);
    const auto known = before.find(pair);
    touchingSince_.emplace_hint(touchingSince_.end(), pair, known == before.end() ? time : known->second);
  }
}

void Recorder::sample(const World& world) {
  Observation now(world);
  if (options_.reference) now.reference = &*options_.reference;
  Sample s{measureWorld(now), measureCells(now), measureContacts(now), {}};
  keepTouching(s.contacts, now.time);
  std::vector<double> durations;  // by (a, b), as the contacts; empty unless recorded
  for (const auto& [pair, since] : touchingSince_) durations.push_back(now.time - since);
  now.contactDurations = durations;
  s.more = takeMeasures(now, options_.measures);
  results_.samples.push_back(std::move(s));
  for (const CellMeasures& c : results_.samples.back().cells) describe(world, c.state);
  const Sample& taken = results_.samples.back();
  bytes_ += double(sizeof(Sample) + taken.cells.size() * (sizeof(CellMeasures) + CellMeasures::bytes()) +
                   taken.contacts.size() * (sizeof(ContactMeasures) + ContactMeasures::bytes()) +
                   taken.more.size() * sizeof(TakenMeasure));
  sampled_ = true;
}

void Recorder::describe(const World& world, StateId state) {
  if (const auto [text, isNew] = results_.stateTexts.try_emplace(state); isNew)
    text->second = world.biology->describe(state);
}

RunResults Recorder::take(const World& world, bool failed) {
  const bool measuredAlready =
      !results_.samples.empty() && results_.samples.back().world.step == world.clock.step;
  if (!failed && !measuredAlready) sample(world);
  const bool hashesEnd = options_.hashEnd || options_.hashEvery;
  if (hashesEnd && !failed && (results_.chain.empty() || results_.chain.back().step != world.clock.step))
    hash(world);

  for (const LineageEntry& e : world.lineage.entries) describe(world, e.state);
  RunResults results = std::exchange(results_, {});
  results.lineage = world.lineage.entries;
  if (options_.nameOf)
    for (const LineageEntry& e : results.lineage)
      if (auto name = options_.nameOf(e.path)) results.names.emplace(e.path, std::move(*name));
  if (world.connections) results.connections = world.connections->history;
  for (const TimeStepChange& t : world.timeSteps) results.timeSteps.push_back({t.time, t.step, t.timeStep});
  results.divisions = world.divisions;
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
