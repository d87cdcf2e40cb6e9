// Reads the world into records. No other source of the store reads the simulation's world.
#include "store/recorder.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {
namespace {

/// Copies the faces of the mesh with number `mesh` from `from`, unless `kept` has them.
void keepFaces(std::vector<MeshFaces>& kept, const std::vector<MeshFaces>& from, int mesh) {
  const auto place = std::ranges::lower_bound(kept, mesh, {}, &MeshFaces::mesh);
  if (place != kept.end() && place->mesh == mesh) return;
  const auto found = std::ranges::find(from, mesh, &MeshFaces::mesh);
  MORULA_CHECK(found != from.end(), "each surface has faces");
  kept.insert(place, *found);
}

/// Returns the memory of a surface [byte].
double bytesOf(const CellSurface& surface) {
  return double(sizeof(CellSurface) + surface.numbers.size() * sizeof(surface.numbers[0]));
}

}  // namespace

void Recorder::observe(const World& world) {
  sampled_ = false;
  pour();
  const Clock& clock = world.clock;
  if (options_.hashEvery && clock.step % *options_.hashEvery == 0) hash(world);
  const bool reached = reaches(world.cells.path.size()), due = isDue(clock.time), surfaces = surfacesAreDue(clock.time);
  if (!divided(world) && !reached && !due && !surfaces) return;
  sample(world, surfaces || (reached && options_.meshes));
  if (due) expectNext(clock.time);
  if (surfaces) expectNextSurfaces(clock.time);
}

std::uint64_t Recorder::stepsUntilDue(const World& world) const {
  const Clock& clock = world.clock;
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  if (options_.hashEvery) steps = *options_.hashEvery - clock.step % *options_.hashEvery;
  if (!world.bodies) return steps;
  const auto at = [&](double time) { steps = std::min(steps, stepsUntil(clock, time)); };
  if (options_.every) at(*every_.next());
  if (options_.meshes) at(*meshes_.next());
  if (nextAt_ < options_.meshesAt.size()) at(options_.meshesAt[nextAt_]);
  return steps;
}

bool Recorder::surfacesAreDue(double time) const {
  return meshes_.isDue(time) || (nextAt_ < options_.meshesAt.size() && time >= options_.meshesAt[nextAt_]);
}

void Recorder::expectNextSurfaces(double time) {
  meshes_.pass(time);
  while (nextAt_ < options_.meshesAt.size() && time >= options_.meshesAt[nextAt_]) ++nextAt_;
}

bool Recorder::reaches(std::uint64_t cells) {
  const std::size_t before = reached_;
  while (reached_ < options_.atCells.size() && cells >= options_.atCells[reached_]) ++reached_;
  return reached_ > before;
}

bool Recorder::divided(const World& world) {
  if (!options_.atDivisions) return false;
  // A division adds both daughters to the lineage, so the lineage grows with each division.
  return std::exchange(divisions_, world.lineage.entries.size()) < world.lineage.entries.size();
}

void Recorder::resume(const World& world, const RunResults& earlier) {
  std::map<StateId, StateId> here;
  for (const auto& [state, text] : earlier.stateTexts) here[state] = world.biology->stateOf(text);
  for (Sample s : earlier.samples) {
    if (s.world.step > world.clock.step || s.world.time > world.clock.time) continue;
    const bool reached = reaches(static_cast<std::uint64_t>(s.world.at("cells"))), due = isDue(s.world.time),
               surfaces = surfacesAreDue(s.world.time);
    if (!reached && !due && !surfaces && !options_.atDivisions) continue;
    if (!surfaces && !(reached && options_.meshes)) s.surfaces.clear();  // surfaces of the stop alone
    for (const CellSurface& surface : s.surfaces) keepFaces(results_.meshes, earlier.meshes, surface.mesh);
    for (CellMeasures& c : s.cells) describe(world, c.state = here.at(c.state));
    keepTouching(s.contacts, s.world.time);
    if (due) expectNext(s.world.time);
    if (surfaces) expectNextSurfaces(s.world.time);
    pour();
    add(std::move(s));
  }
  for (const ChainLink& link : earlier.chain)
    if (options_.hashEvery && link.step <= world.clock.step && link.step % *options_.hashEvery == 0) pour(), add(link);
}

void Recorder::hash(const World& world) { add(nextLink(lastLink_, world)); }

void Recorder::pour() {
  if (!sink_ || bytes_ < enough_) return;
  sink_(results_);
  results_.samples.clear(), results_.chain.clear();
  bytes_ = 0;
}

void Recorder::add(Sample sample) {
  double bytes = double(sizeof(Sample) + sample.cells.size() * (sizeof(CellMeasures) + CellMeasures::bytes()) +
                        sample.contacts.size() * (sizeof(ContactMeasures) + ContactMeasures::bytes()) +
                        sample.more.size() * sizeof(TakenMeasure));
  for (const CellSurface& s : sample.surfaces) bytes += bytesOf(s);
  bytes_ += bytes;
  results_.samples.push_back(std::move(sample));
}

void Recorder::add(ChainLink link) {
  lastLink_ = link.hash;
  bytes_ += double(sizeof(ChainLink) + link.state.cells.size() * sizeof(CellHash));
  results_.chain.push_back(std::move(link));
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

void Recorder::keepSurfaces(const World& world, Sample& sample) {
  if (!world.bodies) return;
  const Bodies& bodies = *world.bodies;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const int slot = bodies.slots[i], level = bodies.blocks[static_cast<std::size_t>(slot / blockLanes)].meshLevel;
    Mesh surface = takeSurface(bodies, slot);
    // takeSurface gives a sphere the egg's mesh with the sphere's volume. Its vertices lie outside the sphere and may
    // stick out of the shell, so they are put onto the sphere.
    const Point centre = bodies.vertex(slot, 0);
    const double radius = bodies.parameters.cell.radius * bodies.restScale[slot];
    if (bodies.areSpheres())
      for (Point& p : surface.vertices) p = centre + (radius / norm(p - centre)) * (p - centre);
    sample.surfaces.push_back(quantise(world.cells.path[i], level, surface.vertices));
    keepFaces(results_.meshes, {{level, surface.vertices.size(), std::move(surface.faces)}}, level);
  }
}

void Recorder::sample(const World& world, bool withSurfaces) {
  Observation now(world);
  if (options_.reference) now.reference = &*options_.reference;
  Sample s{measureWorld(now), measureCells(now), measureContacts(now), {}};
  keepTouching(s.contacts, now.time);
  std::vector<double> durations;  // by (a, b), like the contacts; empty unless recorded
  for (const auto& [pair, since] : touchingSince_) durations.push_back(now.time - since);
  now.contactDurations = durations;
  s.more = takeMeasures(now, options_.measures);
  if (withSurfaces) keepSurfaces(world, s);
  for (const CellMeasures& c : s.cells) describe(world, c.state);
  add(std::move(s));
  sampled_ = true;
}

void Recorder::describe(const World& world, StateId state) {
  if (const auto [text, isNew] = results_.stateTexts.try_emplace(state); isNew)
    text->second = world.biology->describe(state);
}

RunResults Recorder::take(const World& world, bool failed) {
  const bool measuredAlready = !results_.samples.empty() && results_.samples.back().world.step == world.clock.step;
  if (!failed && !measuredAlready) sample(world, options_.meshes.has_value());
  else if (!failed && options_.meshes && results_.samples.back().surfaces.empty())
    keepSurfaces(world, results_.samples.back());
  const bool hashesEnd = options_.hashEnd || options_.hashEvery;
  if (hashesEnd && !failed && (results_.chain.empty() || results_.chain.back().step != world.clock.step)) hash(world);
  lastLink_.reset();

  for (const LineageEntry& e : world.lineage.entries) describe(world, e.state);
  RunResults results = std::exchange(results_, {});
  results.lineage = world.lineage.entries;
  if (options_.nameOf)
    for (const LineageEntry& e : results.lineage)
      if (auto name = options_.nameOf(e.path)) results.names.emplace(e.path, std::move(*name));
  if (world.connections) results.connections = world.connections->history;
  for (const TimeStepChange& t : world.timeSteps) results.timeSteps.push_back({t.time, t.step, t.timeStep});
  if (world.settlings) results.settlings = *world.settlings;
  if (world.experiments) results.experiments = *world.experiments;
  results.divisions = world.divisions;
  return results;
}

RunEnd endOf(const World& world, RunStatus status, const std::string& failure, Want want) {
  RunEnd end{.status = status,
             .steps = world.clock.step,
             .cells = world.cells.path.size(),
             .time = world.clock.time,
             .failure = failure,
             .want = want};
  if (status == RunStatus::done) end.stateHash = stateHash(world);
  return end;
}

}  // namespace morula
