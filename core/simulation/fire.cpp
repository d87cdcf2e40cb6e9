
#include "simulation/fire.h"

#include <algorithm>
#include <cmath>

#include "base/aligned.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/parallel.h"
#include "contacts/contacts.h"
#include "observation/energy.h"
#include "physics/integrator.h"
#include "simulation/check_bodies.h"
#include "simulation/move_physics.h"
#include "simulation/rest.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

constexpr double fireMaxMove = 0.1;  // [mean edge at rest] max move of a vertex in one evaluation
constexpr double farOff = 10;        // [tolerance] a residual above this ends the run
constexpr double nearRest = 0.01;    // [tolerance] residual at which a sampled settling counts as at rest
constexpr double fireInertiaPerStrain = 2, fireClearlyMore = 1.5;
constexpr std::uint64_t fireInertiaEvery = 64;  // evaluations
using PerSlot = AlignedVector<double>;          // filled up to whole blocks

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
      maxMove_[slot] = fireMaxMove * bodies_.meshOf(slot).meanRestLength * bodies_.restScale[slot];
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

  /// Returns r [rest.h] of the last turn.
  double residual() const { return residualOf(world_, squares_); }

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
      const double factor = 1 + fireInertiaPerStrain * strain_[slot];
      if (!anew && factor <= fireClearlyMore * factor_[slot]) continue;
      factor_[slot] = factor;
      hardening_[slot / blockLanes] = 0;  // inertia follows
    }
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
    descent.move(record.evaluations % fireInertiaEvery == 0);
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

}  // namespace

void settleByFire(World& world) {
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

}  // namespace morula
