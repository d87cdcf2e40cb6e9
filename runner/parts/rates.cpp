#include "parts/rates.h"

#include <algorithm>
#include <utility>

#include "bench/clock.h"
#include "bench/packed_world.h"
#include "bench/statistics.h"
#include "bench/work.h"
#include "simulation/hash.h"
#include "simulation/measures.h"

namespace morula {

namespace {

constexpr double longEnough = 1e-3;  // [s] of one timing
constexpr int timings = 7;           // the quickest counts: others were disturbed
// [calls] of one timing. What is moved on by halves of steps for longer goes where no run goes: drag alone
// brings velocities down to numbers that processors are slow with.
constexpr int mostTurns = 64;

/// [s] of one call; `prepare` goes before each timing and does not count.
template <class Prepare, class Call>
double quickest(const Prepare& prepare, const Call& call) {
  prepare();
  double best = timeOf(ClockKind::cpu, call);
  const int turns = std::clamp(static_cast<int>(longEnough / std::max(best, 1e-9)), 1, mostTurns);
  for (int i = 0; i < timings; ++i) {
    prepare();
    const double time = timeOf(ClockKind::cpu, [&] {
      for (int k = 0; k < turns; ++k) call();
    });
    best = std::min(best, time / turns);
  }
  return best;
}

/// What goes through caches between two passes over the same numbers.
class OtherMemory {
 public:
  explicit OtherMemory(double bytes)
      : numbers_(std::size_t(std::clamp(bytes, 0.0, mostBytes)) / sizeof(double), 1) {}
  void goThrough() {
    for (std::size_t i = 0; i < numbers_.size(); i += 8) numbers_[i] += 1;
  }

 private:
  static constexpr double mostBytes = 64 << 20;  // more than caches hold
  std::vector<double> numbers_;
};

/// [s] of one call that finds nothing in the caches but what the call before has left there, after all of a
/// step's other memory.
template <class Prepare, class Call>
double fromMemory(OtherMemory& other, const Prepare& prepare, const Call& call) {
  std::vector<double> times;
  for (int i = 0; i < timings; ++i) {
    prepare();
    other.goThrough();
    times.push_back(timeOf(ClockKind::cpu, call));
  }
  return median(times);
}

/// Cells side by side; a block has eight, however wide the registers.
int widthOf(Isa isa, Precision precision) {
  if (precision == Precision::binary32) return isa == Isa::scalar ? 1 : isa == Isa::narrow ? 4 : 8;
  switch (isa) {
    case Isa::scalar:
      return 1;
    case Isa::narrow:
      return 2;
    case Isa::avx2:
      return 4;
    case Isa::avx512:
      return 8;
  }
  return 1;
}

double vertices(const World& world) { return world.bodies->livingVertices; }

/// A world whose state comes back, however it was moved.
class Trial {
 public:
  explicit Trial(World& world)
      : world_(world),
        position_(world.bodies->position),
        velocity_(world.bodies->velocity),
        acceleration_(world.bodies->acceleration),
        start_(acceleration_) {
    if (world.contacts) rows_ = world.contacts->rows, farthest_ = world.contacts->farthest;
  }
  ~Trial() {
    start_ = acceleration_;
    restore();
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  /// [s] per vertex of the cells that are there.
  template <class Call>
  double time(const Call& ofBlock) {
    const double time = quickest([&] { restore(); },
                                 [&] {
                                   for (int i = 0; i < world_.bodies->blockCount(); ++i)
                                     ofBlock(world_.bodies->block(i, 0), i);
                                 });
    return time / vertices(world_);
  }
  /// The same for a pass over all blocks that comes after another one.
  template <class Call>
  double timePass(OtherMemory& other, const Call& ofBlock) {
    const double time = fromMemory(
        other, [&] { restore(); },
        [&] {
          for (int i = 0; i < world_.bodies->blockCount(); ++i) ofBlock(world_.bodies->block(i, 0), i);
        });
    return time / vertices(world_);
  }
  /// From now on it begins without forces.
  void dropForces() { start_.assign(start_.size(), 0); }

 private:
  void restore() {
    Bodies& b = *world_.bodies;
    b.position = position_, b.velocity = velocity_, b.acceleration = start_;
    if (world_.contacts) world_.contacts->rows = rows_, world_.contacts->farthest = farthest_;
  }
  World& world_;
  Reals position_, velocity_, acceleration_, start_;
  AlignedVector<RowMemory> rows_;
  AlignedVector<double> farthest_;
};

/// A cell's own step with other parameters than the scene's.
double timeOwnStep(World& world, Trial& trial, const PhysicsParameters& parameters) {
  Bodies& b = *world.bodies;
  const KernelParameters before = b.kernelParameters;
  b.kernelParameters.damping = parameters.membrane.damping;
  b.kernelParameters.drag = parameters.drag;
  const PhysicsStages stages = chooseStages(parameters, world.execution.isa, world.contacts.has_value());
  const double time = trial.time([&](const BlockView& block, int) {
    advance(stages, b, block, world.clock.timeStep);
    kick(stages, b, block, world.clock.timeStep);
  });
  b.kernelParameters = before;
  return time;
}

void measureOwnStep(World& world, OtherMemory& memory, StepRates& rates) {
  Trial trial(world);
  Bodies& b = *world.bodies;
  const PhysicsParameters all = b.parameters;
  const double whole = timeOwnStep(world, trial, all);
  PhysicsParameters less = all;
  const auto without = [&](bool engaged, auto&& leaveOut) {
    if (!engaged) return 0.0;
    less = all;
    leaveOut(less);
    return std::max(whole - timeOwnStep(world, trial, less), 0.0);
  };
  const bool shells = all.cell.model == CellModel::shell;
  rates.damping = without(shells && all.membrane.damping > 0, [](auto& p) { p.membrane.damping = 0; });
  rates.drag = without(all.drag > 0, [](auto& p) { p.drag = 0; });
  rates.shell = without(all.shell.has_value(), [](auto& p) { p.shell.reset(); });
  // Its two halves come first in their passes, and bring what all others then find near.
  trial.dropForces();  // kicks turn forces into accelerations: without new ones only zero stays what it is
  PhysicsParameters open = all;
  open.shell.reset();
  const PhysicsStages inTheOpen = chooseStages(open, world.execution.isa);
  const auto drift = [&](const BlockView& block, int) {
    inTheOpen.drift(b.meshAt(block.coarseness).view(), block, b.kernelParameters, world.clock.timeStep);
  };
  const auto end = [&](const BlockView& block, int) {
    inTheOpen.kick(b.meshAt(block.coarseness).view(), block, b.kernelParameters, world.clock.timeStep);
  };
  rates.integration = trial.timePass(memory, drift) + trial.timePass(memory, end);
  const double inOnePass = trial.time([&](const BlockView& block, int i) { drift(block, i), end(block, i); });
  // Springs and pressure share a walk around each vertex; they are told apart by counting.
  const double rest = std::max(whole - rates.damping - rates.drag - rates.shell - inOnePass, 0.0);
  if (b.areSpheres()) {
    rates.integration += rest;  // that of finding the volumes, which no part of its own stands for
    return;
  }
  if (!shells) {
    rates.shapeMatching = rest;
    return;
  }
  PhysicsParameters plain = all;
  plain.membrane.damping = plain.drag = 0;
  const double share = springShare(b.mesh, plain);
  rates.springs = share * rest;
  rates.pressure = (1 - share) * rest;
}

double timeForces(World& world, OtherMemory& memory, Trial& trial) {
  return trial.timePass(memory, [&](const BlockView&, int i) {
    addContactForces(*world.contacts, *world.bodies, i, world.clock.timeStep);
  });
}

void measureContact(World& world, OtherMemory& memory, StepRates& rates) {
  Trial trial(world);
  Bodies& b = *world.bodies;
  Contacts& c = *world.contacts;
  rates.snapshots =
      trial.timePass(memory, [&](const BlockView& block, int i) { takeSnapshot(c, b, block, i); });
  const double perVertex = double(c.list.pairs) / vertices(world);
  const double forces = timeForces(world, memory, trial);
  rates.pair = forces / perVertex;
  if (c.parameters.law == ContactLaw::pair && c.parameters.friction > 0) {
    ContactParameters smooth = c.parameters;
    smooth.friction = 0;
    const auto own = std::exchange(c.addForces, makeContacts(smooth, world.execution.isa, {},
                                                             b.parameters.precision, b.parameters.cell.model)
                                                    .addForces);
    rates.frictionOfPair = std::max(forces - timeForces(world, memory, trial), 0.0) / perVertex;
    rates.pair -= rates.frictionOfPair;
    c.addForces = own;
  }
  Contacts other = makeContacts(c.parameters, world.execution.isa, world.execution.search,
                                b.parameters.precision, b.parameters.cell.model);
  resetContacts(other, b);
  rates.search = fromMemory(
                     memory, [&] { other.listIsValid = false; }, [&] { refreshList(other, b, 1); }) /
                 vertices(world);
}

/// Few and coarse cells, so that they are packed in a moment.
void borrowContact(const World& world, OtherMemory& memory, StepRates& rates) {
  const PackedScene packed{.cells = 8,
                           .level = 1,
                           .friction = world.contacts->parameters.friction,
                           .precision = world.bodies->parameters.precision};
  World other = makePackedWorld(packed, world.execution, "", [](const std::string&) {});
  measureContact(other, memory, rates);
}

}  // namespace

double laneShare(Isa isa, std::uint64_t cells, Precision precision) {
  if (cells == 0) return 1;
  const auto width = static_cast<std::uint64_t>(widthOf(isa, precision));
  return double((cells + width - 1) / width * width) / double(cells);
}

StepRates measureRates(World& world, double bytes) {
  StepRates rates;
  OtherMemory memory(bytes);
  if (world.bodies->count == 0) return rates;
  rates.evaluations = 1 + static_cast<int>(world.stages.furtherDrifts.size());
  measureOwnStep(world, memory, rates);
  const double share = laneShare(world.execution.isa, static_cast<std::uint64_t>(world.bodies->count),
                                 world.bodies->parameters.precision);
  if (world.contacts) {
    if (world.contacts->list.pairs > 0) {
      measureContact(world, memory, rates);
      rates.snapshots /= share;
    } else {
      borrowContact(world, memory, rates);
    }
  }
  for (double* rate : {&rates.springs, &rates.damping, &rates.pressure, &rates.shapeMatching, &rates.drag,
                       &rates.integration, &rates.shell})
    *rate /= share;
  if (world.connections) {
    Trial trial(world);
    rates.connections = trial.time([&](const BlockView&, int i) {
      if (i == 0) addConnectionForces(*world.connections, world.cells.path, *world.bodies);
    });
  }
  return rates;
}

ObservationRates measureObservation(const World& world) {
  ObservationRates rates;
  const double count = world.bodies ? std::max(vertices(world), 1.0) : 1;
  const auto nothing = [] {};
  rates.hash = quickest(nothing, [&] { stateHash(world); }) / count;
  rates.sample = quickest(nothing,
                          [&] {
                            const Observation now(world);
                            measureWorld(now);
                            measureCells(now);
                            measureContacts(now);
                          }) /
                 count;
  return rates;
}

}  // namespace morula
