#include "bench/subject.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "contacts/contacts.h"
#include "simulation/make_world.h"
#include "simulation/move_physics.h"
#include "simulation/simulation.h"

namespace morula {
namespace {

constexpr double stageSeconds = 2e-3;    // [s] min duration of one timing of a stage
constexpr double groupSeconds = 1.5e-4;  // [s] min duration of one timing of whole steps, against the clock's cost
constexpr int warmUp = 2 * stirEvery;
constexpr int settlingIn = 4;  // [steps] until pairs are chosen by the observed speed of gaps

/// Returns the time of one call [s], over as many calls as take long enough, after an uncounted one.
template <class Call>
double secondsPerCall(ClockKind clock, const Call& call) {
  const double first = timeOf(clock, call);
  const int turns = std::clamp(static_cast<int>(stageSeconds / std::max(first, 1e-9)), 1, 100000);
  return timeOf(clock,
                [&] {
                  for (int i = 0; i < turns; ++i) call();
                }) /
         turns;
}

}  // namespace

std::uint64_t countSlots(const Contacts& c) {
  std::uint64_t slots = 0;
  for (const BlockLists& block : c.list.perBlock)
    for (const NeighbourSlice& slice : block.slices) slots += std::uint64_t(slice.length) * blockLanes;
  return slots;
}

void stir(World& world) {
  Bodies& b = *world.bodies;
  const double edge = b.mesh.meanRestLength * b.restScale[0];
  const double wanted = stirredMove * edge / world.clock.timeStep;
  double squares = 0;
  for (int slot = 0; slot < b.count; ++slot) {
    const Vector push = wanted * randomDirection({0, world.cells.path[slot],
                                                  static_cast<std::uint32_t>(world.clock.step), Purpose::perturbation});
    for (int v = 0; v < b.vertexCount(); ++v) {
      const Vector now = b.read(b.velocity, slot, v) + push;
      b.write(b.velocity, slot, v, now);
      squares += dot(now, now);
    }
  }
  const double scale = wanted / std::sqrt(squares / (double(b.count) * b.vertexCount()));
  for (std::size_t i = 0; i < b.velocity.size(); ++i) b.velocity[i] = scale * b.velocity[i];
}

Subject::Subject(const PackedScene& packed, int maxThreads, const std::filesystem::path& folder,
                 const std::function<void(const std::string&)>& tell)
    : world_(makePackedWorld(packed, {.isa = bestIsa(), .threads = maxThreads}, folder, tell)),
      stirred_(packed.stirred) {
  useIsa(bestIsa(), 1);
  goOn(bestIsa(), warmUp);
  counters_ = {};
  for (int slot = 0; slot < world_.bodies->count; ++slot)
    ordinary_.push_back(makeOrdinaryCell(world_.bodies->mesh, takeBody(*world_.bodies, slot)));
}

Contacts Subject::contactsWith(Isa isa, const SearchSettings& search) const {
  const PhysicsParameters& p = world_.bodies->parameters;
  return makeContacts(world_.contacts->parameters, isa, search, p.precision, p.cell.model);
}

void Subject::useIsa(Isa isa, int threads) {
  world_.execution.isa = isa;
  world_.execution.threads = threads;
  setStages(world_, isa);
  if (!world_.contacts) return;
  Contacts& c = *world_.contacts;
  const Contacts other = contactsWith(isa, world_.execution.search);
  c.kernels = other.kernels;
  c.takeSnapshot = other.takeSnapshot;
  c.addForces = other.addForces;
  c.list.kernels = other.list.kernels;
}

Subject::State Subject::keep() const {
  const Bodies& b = *world_.bodies;
  State s{b.position, b.velocity, b.acceleration, {}, {}, {}};
  if (!world_.contacts) return s;
  const Contacts& c = *world_.contacts;
  s.rows = c.rows, s.farthest = c.farthest, s.acting = c.acting;
  return s;
}

void Subject::restore(const State& s) {
  Bodies& b = *world_.bodies;
  b.position = s.position, b.velocity = s.velocity, b.acceleration = s.acceleration;
  if (!world_.contacts) return;
  Contacts& c = *world_.contacts;
  c.rows = s.rows, c.farthest = s.farthest, c.acting = s.acting;
}

template <class Call>
double Subject::timeBlocks(Isa isa, const Call& call) {
  useIsa(isa, 1);
  const State before = keep();
  const double time = secondsPerCall(ClockKind::cpu, [&] {
    for (int i = 0; i < world_.bodies->blockCount(); ++i) call(i);
  });
  restore(before);
  return time / vertices();
}

double Subject::timeInternal(Isa isa) {
  Bodies& b = *world_.bodies;
  const TemplateView mesh = b.mesh.view();
  return timeBlocks(isa, [&](int i) {
    const BlockView block = b.block(i, 0);
    world_.stages.findTensions(mesh, block, b.kernelParameters);
    world_.stages.accumulateRings(mesh, block, b.kernelParameters);
    world_.stages.addBending(mesh, block, b.kernelParameters);
    world_.stages.finishForces(mesh, block, b.kernelParameters);
  });
}

double Subject::timeIntegration(Isa isa) {
  Bodies& b = *world_.bodies;
  const TemplateView mesh = b.mesh.view();
  // Kicks turn forces into accelerations. Without new forces between kicks only zero keeps its value.
  const Reals kept = b.acceleration;
  b.acceleration.assign(b.acceleration.size(), 0);
  const double dt = world_.clock.timeStep;
  const double time = timeBlocks(isa, [&](int i) {
    const BlockView block = b.block(i, 0);
    world_.stages.drift(mesh, block, b.kernelParameters, dt);
    kick(world_.stages, b, block, dt);
  });
  b.acceleration = kept;
  return time;
}

double Subject::timeContact(Isa isa) {
  Bodies& b = *world_.bodies;
  Contacts& c = *world_.contacts;
  // Snapshots come from the last block's scratch, at the cost of the right one, also in the cache.
  return timeBlocks(isa, [&](int i) { takeSnapshot(c, b, b.block(i, 0), i); }) +
         timeBlocks(isa, [&](int i) { addContactForces(c, b, i, world_.clock.timeStep); });
}

Contacts Subject::contactsToSearch(Isa isa, ContactSearch method) const {
  Contacts contacts = contactsWith(isa, {.method = method});
  resetContacts(contacts, *world_.bodies);
  contacts.rows = world_.contacts->rows;  // the positions of surfaces
  return contacts;
}

double Subject::timeRebuild(Isa isa, ContactSearch method, ClockKind clock, int threads) {
  Contacts other = contactsToSearch(isa, method);
  refreshList(other, *world_.bodies, threads);  // takes the points to search
  return secondsPerCall(clock, [&] { findNeighbourLists(other.list, *world_.bodies, other.radius, threads); }) /
         vertices();
}

double Subject::lists() const {
  double lists = 0;
  for (const BlockLists& block : world_.contacts->list.perBlock)
    lists += double(std::ranges::count_if(block.length, [](std::int32_t length) { return length > 0; }));
  return lists;
}

double Subject::timeChoice(Isa isa, ClockKind clock, int threads) {
  Contacts other = *world_.contacts;
  other.kernels = contactsWith(isa, world_.execution.search).kernels;
  ActingPairs before = other.acting;  // how fast gaps change decides how many pairs are chosen
  before.endedSoon = 0;
  return secondsPerCall(clock,
                        [&] {
                          other.acting = before;
                          choosePairs(other, *world_.bodies, threads);
                        }) /
         vertices();
}

double Subject::timeOrdinaryForces() {
  return secondsPerCall(ClockKind::cpu,
                        [&] {
                          for (OrdinaryCell& cell : ordinary_) findForces(cell, world_.bodies->parameters);
                        }) /
         vertices();
}

template <class Each, class After>
StepTime Subject::timeSteps(ClockKind clock, int count, const Each& each, const After& after) {
  double total = 0;
  int counted = 0;
  const auto rebuilds = [&] { return world_.contacts ? world_.contacts->rebuilds : 0; };
  int size = touching() ? 1 : stirEvery;  // independent cells take many steps at once
  double disturbed = NAN;                 // time of a group with a search, used if all groups have one
  for (int done = 0; done < count;) {
    const auto before = rebuilds();
    const int steps = std::min({size, count - done, stirEvery - done % stirEvery});
    const double time = timeOf(clock,
                               [&] {
                                 const std::uint64_t end = world_.clock.step + static_cast<std::uint64_t>(steps);
                                 while (world_.clock.step < end) takeSteps(world_, end - world_.clock.step), each();
                               }) /
                        steps;
    done += steps;
    after(done);
    if (rebuilds() == before) total += time * steps, counted += steps;
    else disturbed = time;
    if (touching()) size = std::clamp(static_cast<int>(groupSeconds / std::max(time, 1e-9)), 1, stirEvery);
  }
  return (counted > 0 ? total / counted : disturbed) / vertices();
}

StepTime Subject::trySteps(Isa isa, int threads, ClockKind clock, int count) {
  useIsa(isa, threads);
  const State before = keep();
  const Clock clockBefore = world_.clock;
  // The state's list of neighbours is set aside, and put back afterwards.
  Indirect<Contacts> other;
  if (world_.contacts) {
    other = contactsWith(isa, world_.execution.search);
    resetContacts(*other, *world_.bodies);
    std::swap(other, world_.contacts);
  }
  evaluateForces(world_);
  for (int i = 0; i < settlingIn; ++i) takeSteps(world_, 1);
  const StepTime time = timeSteps(
      clock, count, [] {}, [](int) {});
  if (other) std::swap(other, world_.contacts);
  world_.clock = clockBefore;
  restore(before);
  useIsa(bestIsa(), 1);
  return time;
}

StepTime Subject::goOn(Isa isa, int count) {
  useIsa(isa, 1);
  if (stirred_) stir(world_);
  const auto rebuilds = world_.contacts ? world_.contacts->rebuilds : 0;
  const auto thinned = world_.contacts ? world_.contacts->listsThinned : 0;
  const StepTime time = timeSteps(
      ClockKind::cpu, count,
      [&] {
        if (world_.contacts) counters_.pairs += world_.contacts->list.pairs;
      },
      [&](int done) {
        if (done % stirEvery != 0 && done != count) return;  // where other groups end is the clock's doing
        if (world_.contacts) counters_.slots += countSlots(*world_.contacts), ++counters_.looks;
        if (stirred_ && done % stirEvery == 0) stir(world_);
      });
  counters_.steps += static_cast<std::uint64_t>(count);
  if (!world_.contacts) return time;
  counters_.rebuilds += world_.contacts->rebuilds - rebuilds;
  counters_.listsThinned += world_.contacts->listsThinned - thinned;
  return time;
}

}  // namespace morula
