#include "parts/rates.h"

#include <algorithm>

#include "base/error.h"
#include "bench/packed_world.h"
#include "bench/subject.h"
#include "bench/work.h"
#include "contacts/contacts.h"
#include "observation/measures.h"
#include "simulation/make_world.h"
#include "simulation/move_physics.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"
#include "system/clock.h"

namespace morula {
namespace {

constexpr double timingSeconds = 1e-3;  // [s] min duration of one timing
constexpr int timings = 7;              // number of timings, of which the shortest counts, as others were disturbed
constexpr int maxTurns = 64;            // [calls] max number in one timing

/// Returns the shortest time of a call [s]. `prepare`: is called before each timing and does not count.
template <class Prepare, class Call>
double quickest(const Prepare& prepare, const Call& call) {
  prepare();
  double best = timeOf(ClockKind::cpu, call);
  const int turns = std::clamp(static_cast<int>(timingSeconds / std::max(best, 1e-9)), 1, maxTurns);
  for (int i = 0; i < timings; ++i) {
    prepare();
    const double time = timeOf(ClockKind::cpu, [&] {
      for (int k = 0; k < turns; ++k) call();
    });
    best = std::min(best, time / turns);
  }
  return best;
}

double vertices(const World& world) { return world.bodies->livingVertices; }

using Change = std::function<void(World&)>;

/// A world from which parts are taken for a while. Each timing restores its state.
class Timing {
 public:
  explicit Timing(World& world)
      : world_(world),
        bodies_(world.bodies),
        contacts_(world.contacts),
        connections_(world.connections),
        threads_(world.execution.threads) {}
  ~Timing() {
    restore();
    world_.execution.threads = threads_;
    setStages(world_, world_.execution.isa);
  }
  Timing(const Timing&) = delete;
  Timing& operator=(const Timing&) = delete;

  /// Returns the time of one call [s] per vertex, on the restored and then changed world.
  double of(const Change& change, const Change& call) {
    return quickest(
               [&] {
                 restore();
                 change(world_);
                 world_.execution.threads = 1;
                 setStages(world_, world_.execution.isa);
               },
               [&] { call(world_); }) /
           vertices(world_);
  }
  /// Measures the time of one step of the physics.
  double ofStep(const Change& change) {
    return of(change, [](World& w) { movePhysics(w, w.clock.timeStep); });
  }

 private:
  void restore() { world_.bodies = bodies_, world_.contacts = contacts_, world_.connections = connections_; }

  World& world_;
  std::optional<Bodies> bodies_;
  Indirect<Contacts> contacts_;
  std::optional<Connections> connections_;
  int threads_;
};

void keepAlone(World& w) { w.contacts.reset(), w.connections.reset(); }

/// Drifts and kicks, without evaluating forces.
void integrateOnly(World& w) {
  Bodies& b = *w.bodies;
  for (int i = 0; i < b.blockCount(); ++i) {
    const BlockView block = b.block(i, 0);
    w.stages.drift(b.meshAt(block.meshLevel).view(), block, b.kernelParameters, w.clock.timeStep);
    kick(w.stages, b, block, w.clock.timeStep);
  }
}

/// Measures the work within each cell. Springs and pressure share a walk around each vertex, so they are separated by
/// counting.
void measureOwnStep(World& world, StepRates& rates) {
  Timing timing(world);
  const PhysicsParameters p = world.bodies->parameters;
  const bool shells = world.bodies->model().hasMembrane;
  const double whole = timing.ofStep(keepAlone);
  const auto costOf = [&](bool engaged, const Change& leaveOut) {
    if (!engaged) return 0.0;
    return std::max(whole - timing.ofStep([&](World& w) { keepAlone(w), leaveOut(w); }), 0.0);
  };
  rates.damping = costOf(shells && p.membrane.damping.acts(), [](World& w) {
    w.bodies->parameters.membrane.damping = 0;
    w.bodies->kernelParameters = kernelParametersOf(w.bodies->parameters);
  });
  rates.bending = costOf(shells && p.membrane.bending > 0, [](World& w) { w.bodies->parameters.membrane.bending = 0; });
  rates.drag = costOf(p.drag > 0, [](World& w) { w.bodies->parameters.drag = w.bodies->kernelParameters.drag = 0; });
  rates.shell = costOf(p.shell.has_value(), [](World& w) { w.bodies->parameters.shell.reset(); });
  rates.integration = timing.of(
      [](World& w) {
        keepAlone(w);
        w.bodies->parameters.shell.reset();
        w.bodies->acceleration.assign(w.bodies->acceleration.size(), 0);
      },
      integrateOnly);
  const double rest = std::max(whole - rates.damping - rates.bending - rates.drag - rates.shell - rates.integration, 0.0);
  PhysicsParameters plain = p;
  plain.membrane.damping = 0;
  plain.drag = 0;
  const double share = shells ? springShare(world.bodies->mesh, plain) : 0;
  if (world.bodies->areSpheres()) rates.integration += rest;  // finding the volumes counts as integration
  else if (!shells) rates.shapeMatching = rest;
  else rates.springs = share * rest, rates.pressure = (1 - share) * rest;
  if (world.connections)
    rates.connections =
        timing.of([](World&) {}, [](World& w) { addConnectionForces(*w.connections, w.cells.path, *w.bodies); });
}

/// Measures the work of touching cells. Snapshots and pairs are separated by counting.
void measureContact(World& world, StepRates& rates) {
  Timing timing(world);
  const Contacts own = *world.contacts;
  const auto remake = [&world](const ContactParameters& p) {
    return makeContacts(p, world.execution.isa, world.execution.search, world.bodies->parameters.precision,
                        world.bodies->parameters.cell.model);
  };
  const auto smooth = [&](World& w) {
    ContactParameters p = own.parameters;
    p.viscosity = 0;
    w.contacts->parameters.viscosity = 0;
    w.contacts->addForces = remake(p).addForces;
    w.connections.reset();
  };
  const double alone = timing.ofStep(keepAlone), perVertex = double(own.list.pairs) / vertices(world);
  const double evaluations = 1 + double(world.stages.furtherDrifts.size());  // force evaluations in a step
  const double all = timing.ofStep([](World& w) { w.connections.reset(); }) - alone;
  const bool slips = own.parameters.law != ContactLaw::thesis && own.parameters.viscosity > 0;
  const double viscosity = slips ? std::clamp(all + alone - timing.ofStep(smooth), 0.0, std::max(all, 0.0)) : 0;
  const double slots = double(countSlots(own)) / vertices(world);
  const auto operations = [&](double n) {  // a plain snapshot has 16, its pairs some 50, with v·h, κ and the fade
    return own.scratch.empty() ? 16 + 50 * n : contactWork(world.bodies->mesh, n, false).operations;
  };
  const double snapshots = operations(0) / operations(slots);
  rates.viscosityOfPair = viscosity / (evaluations * perVertex);
  rates.snapshots = std::max(all - viscosity, 0.0) * snapshots;
  rates.pair = std::max(all - viscosity, 0.0) * (1 - snapshots) / (evaluations * perVertex);
  Contacts other = own;  // a copy with the rows from which lists are built
  rates.search = timing.of([&](World&) { other.listIsValid = false; },
                           [&](World& w) { other.listIsValid = false, refreshList(other, *w.bodies, 1); });
}

}  // namespace

double laneShare(Isa isa, std::uint64_t cells, Precision precision) {
  if (cells == 0) return 1;
  const int doubles = 1 << static_cast<int>(isa);  // doubles in a register: scalar 1, narrow 2, avx2 4, avx512 8
  const int lanes = isa == Isa::scalar || precision == Precision::binary64 ? doubles : 2 * doubles;
  const auto width = static_cast<std::uint64_t>(std::min(lanes, blockLanes));
  return double((cells + width - 1) / width * width) / double(cells);
}

StepRates measureRates(World& world) {
  StepRates rates;
  if (world.bodies->count == 0) return rates;
  measureOwnStep(world, rates);
  const double share = laneShare(world.execution.isa, static_cast<std::uint64_t>(world.bodies->count),
                                 world.bodies->parameters.precision);
  if (world.contacts && world.contacts->list.pairs > 0) {
    measureContact(world, rates);
    rates.snapshots /= share;
  } else if (world.contacts) {  // packing few and coarse cells takes a moment
    World packed = makePackedWorld({.cells = 8,
                                    .level = 1,
                                    .viscosity = world.contacts->parameters.viscosity,
                                    .precision = world.bodies->parameters.precision},
                                   world.execution);
    measureContact(packed, rates);
  }
  for (double* rate : {&rates.springs, &rates.damping, &rates.bending, &rates.pressure, &rates.shapeMatching, &rates.drag,
                       &rates.integration, &rates.shell})
    *rate /= share;
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
                            measureWorld(now), measureCells(now), measureContacts(now);
                          }) /
                 count;
  return rates;
}

}  // namespace morula
