
#include "simulation/settle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/aligned.h"
#include "base/error.h"
#include "base/maths.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "contacts/contacts.h"
#include "observation/energy.h"
#include "physics/integrator.h"
#include "simulation/cell_cycles.h"
#include "simulation/check_bodies.h"
#include "simulation/connect.h"
#include "simulation/experiments.h"
#include "simulation/move_physics.h"
#include "simulation/run_end.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

constexpr double maxMove = 0.1;    // [mean edge at rest] max move of a vertex in one evaluation
constexpr double minStrain = 0.1;  // [k_s/R] min p̂
constexpr double farOff = 10;      // [tolerance] a residual above this ends the run
constexpr double nearRest = 0.01;  // [tolerance] residual at which a sampled settling counts as at rest
constexpr double inertiaPerStrain = 2, clearlyMore = 1.5;
constexpr std::uint64_t inertiaEvery = 64;  // evaluations
using PerSlot = AlignedVector<double>;      // filled up to whole blocks

/// A world on its way to rest. The destructor gives cells their masses back.
class Descent {
 public:
  explicit Descent(World& world)
      : world_(world),
        bodies_(*world.bodies),
        masses_(bodies_.vertexMass),
        maxMove_(masses_.size(), 1),
        alpha_(masses_.size(), 0),
        descents_(masses_.size(), 0),
        squares_(masses_.size(), 0),
        strain_(masses_.size(), 0),
        factor_(masses_.size(), 1),
        hardening_(bodies_.blockCount(), 1) {
    for (int slot : bodies_.slots)
      maxMove_[slot] = maxMove * bodies_.meshOf(slot).meanRestLength * bodies_.restScale[slot];
    stop();
    evaluateForces(world_);
    followInertia(world_, hardening_, factor_, true);
  }

  ~Descent() {
    stop();
    for (int slot : bodies_.slots) setVertexMass(bodies_, slot, masses_[slot]);
  }
  Descent(const Descent&) = delete;
  Descent& operator=(const Descent&) = delete;

  /// Chooses the next velocities by the forces of the last evaluation.
  void turn() {
    const PhysicsKernels& kernels = physicsKernels(world_.execution.isa, bodies_.parameters.precision);
    parallelFor(bodies_.blockCount(), world_.execution.threads, [&](int i) {
      const BlockView block = bodies_.block(i, threadNumber());
      const std::size_t first = std::size_t(i) * blockLanes;
      kernels.relaxVelocities(bodies_.meshAt(block.meshLevel).view(), block,
                              {&maxMove_[first], &alpha_[first], &descents_[first], &strain_[first], &squares_[first]});
    });
  }

  void move(bool inertiaAnew) {
    followStrain(inertiaAnew);
    followInertia(world_, hardening_, factor_, inertiaAnew);
    movePhysics(world_, 1);
    checkBodies(world_);
  }

  /// Returns r [settle.h] of the last turn.
  double residual() const {
    double left = 0, pressure = 0, vertices = 0;
    for (int slot : bodies_.slots) {
      const double radius = cubeRoot(3 * bodies_.volume[slot] / (4 * std::numbers::pi));
      const double count = bodies_.vertexCount(slot);
      const double traction = bodies_.vertexMass[slot] * count / (4 * std::numbers::pi * radius * radius);
      left += traction * traction * squares_[slot];
      vertices += count;
      pressure += scale(slot, radius);
    }
    return std::sqrt(left / vertices) / (pressure / bodies_.count);
  }

  /// Returns the number of the cell with the largest forces.
  std::size_t restless() const {
    const auto force = [&](int slot) {
      const double mass = bodies_.vertexMass[slot];
      return mass * mass * squares_[slot];
    };
    return std::size_t(std::ranges::max_element(bodies_.slots, {}, force) - bodies_.slots.begin());
  }

 private:
  /// Gives more inertia to a cell that keeps going uphill at once. Such a cell is stiffer than its limits say, where
  /// its membrane has folded, and would oscillate without end.
  void followStrain(bool anew) {
    for (int slot : bodies_.slots) {
      const double factor = 1 + inertiaPerStrain * strain_[slot];
      if (!anew && factor <= clearlyMore * factor_[slot]) continue;
      factor_[slot] = factor;
      hardening_[slot / blockLanes] = 0;  // inertia follows
    }
  }

  /// Returns p̂ [force/length²] of settle.h.
  double scale(int slot, double radius) const {
    const PhysicsParameters& p = bodies_.parameters;
    const double stiffness = !bodies_.areSpheres() ? p.membrane.stiffness
                             : world_.contacts     ? world_.contacts->parameters.stiffness
                                                   : 1;
    return std::max(std::abs(bodies_.pressure[slot]), minStrain * stiffness / radius);
  }

  void stop() {
    for (int slot : bodies_.slots)
      for (int v = 0; v < bodies_.vertexCount(slot); ++v) bodies_.write(bodies_.velocity, slot, v, {});
  }

  World& world_;
  Bodies& bodies_;
  PerSlot masses_, maxMove_, alpha_, descents_, squares_, strain_, factor_;
  std::vector<double> hardening_;  // [block] [1] hardening that inertia counts with
};

/// Relaxes until r is at most `tolerance`, or `most` evaluations have been made.
void descend(Descent& descent, double tolerance, std::uint64_t most, SettlingRecord& record) {
  while (!(record.residual <= tolerance) && record.evaluations < most) {
    descent.move(record.evaluations % inertiaEvery == 0);
    descent.turn();
    ++record.evaluations;
    record.residual = descent.residual();
  }
}

/// Returns the world's energy [force·length] without motion.
double heldEnergy(const World& world) {
  const Energy energy = measureEnergy(world);
  return energy.total() - energy.kinetic;
}

/// Settles further, measures how far from rest the world was, and restores the state bit for bit. Records nothing if a
/// cell fails meanwhile.
void measureDistance(World& world, Descent& descent, SettlingRecord& record) {
  Bodies& b = *world.bodies;
  const SettleParameters& p = b.parameters.settle;
  const Bodies before = b;
  const auto rows = world.contacts ? world.contacts->rows : decltype(Contacts::rows)();
  const auto deepest = world.contacts ? world.contacts->deepest : AlignedVector<double>();
  const double energy = heldEnergy(world);
  SettlingRecord on = record;
  try {
    descend(descent, nearRest * p.tolerance, record.evaluations + p.evaluations, on);
    double farthest = 0;
    for (int slot : b.slots)
      for (int v = 0; v < b.vertexCount(slot); ++v)
        farthest = std::max(farthest, norm(b.vertex(slot, v) - before.vertex(slot, v)));
    record.energyLeft = energy - heldEnergy(world);
    record.displacementLeft = farthest;
  } catch (const NumericalError&) {}
  b = before;
  if (world.contacts) world.contacts->listIsValid = false;
  evaluateForces(world);  // so that lists are as before
  b = before;             // and accelerations, which have followed changes of inertia
  if (world.contacts) {   // evaluateForces applies the shell again, which moves vertices slightly
    world.contacts->rows = rows;
    world.contacts->deepest = deepest;
  }
}

void settle(World& world) {
  if (world.bodies->count == 0) return;
  const SettleParameters& p = world.bodies->parameters.settle;
  SettlingRecord record{.time = world.clock.time, .step = world.clock.step, .cells = world.cells.path.size()};
  Descent descent(world);
  descent.turn();
  record.evaluations = 1;
  record.residual = descent.residual();
  descend(descent, p.tolerance, p.evaluations, record);
  world.settlings->push_back(record);
  if (!(record.residual <= farOff * p.tolerance))
    throw NumericalError(
        world.cells.path[descent.restless()].text(), record.step,
        "after " + std::to_string(p.evaluations) + " evaluations forces are " + numberText(record.residual) +
            " of what holds cells in shape, more than " + numberText(farOff) + " times physics.settle.tolerance " +
            exactText(p.tolerance) + ": cells are far from rest",
        "give more physics.settle.evaluations or a larger physics.settle.tolerance, or lower a stiffness "
        "(physics.contact.stiffness, physics.pressure.constant)");
  if (p.sample && record.step % *p.sample == 0) measureDistance(world, descent, world.settlings->back());
}

/// Returns the time [time] of the next event.
double nextEvent(const World& world) {
  const Clock& clock = world.clock;
  const PhysicsParameters& p = world.bodies->parameters;
  double next = clock.nextCycle > clock.time ? clock.nextCycle + p.settle.together : INFINITY;
  if (p.growth) {
    double fastest = 0;
    for (double growth : world.cells.growth) fastest = std::max(fastest, std::abs(growth));
    // Cells that wait for a size are asked as often as if they grew.
    if (fastest > 0 || next == INFINITY)
      next = std::min(next, clock.time + maxGrowth / (p.growth->rate * std::max(fastest, 1.0)));
  }
  const double experiment = std::max(clock.time, nextExperiment(world));
  return std::min({next, plannedEnd(world.model).value_or(INFINITY), experiment});
}

}  // namespace

bool settles(const World& world) { return world.bodies && kindOf(world.bodies->parameters.integrator).settles; }

void stepQuasiStatic(World& world) {
  Clock& clock = world.clock;
  const double before = clock.time;
  if (clock.step++ > 0) {
    clock.time = nextEvent(world);
    growCells(world, clock.time - before);
    releaseConnections(world);
    runEvents(world, before, dueUntil(world, before));
  }
  settle(world);
}

}  // namespace morula
