#include "simulation/damped_motion.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "observation/body_measures.h"
#include "simulation/check_bodies.h"
#include "simulation/move_physics.h"
#include "simulation/rest.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

constexpr double maxMove = 0.1;             // [mean edge at rest] max move of a vertex in one evaluation
constexpr double stiffest = 2.56;           // [1] σ of the stiffest motion that inertia is meant for, (0.8 · 2)²
constexpr std::uint64_t inertiaEvery = 64;  // evaluations
// A cell's inertia grows by inertiaPerStrain for each evaluation of late in which σ was above `stiffest`.
constexpr double strainDecay = 1 - 1.0 / 64, inertiaPerStrain = 2, clearlyMore = 1.5;

}  // namespace

DampedMotion::DampedMotion(World& world, double interval)
    : world_(world),
      bodies_(*world.bodies),
      interval_(interval),
      masses_(bodies_.vertexMass),
      maxMove_(masses_.size(), 1),
      drag_(masses_.size(), 0),
      power_(masses_.size(), NAN),
      stiffness_(masses_.size(), 0),
      strain_(masses_.size(), 0),
      factor_(masses_.size(), interval * interval),
      hardening_(bodies_.blockCount(), 1) {
  for (int slot : bodies_.slots)
    maxMove_[slot] = maxMove * bodies_.meshOf(slot).meanRestLength * bodies_.restScale[slot];
}

DampedMotion::~DampedMotion() {
  for (int slot : bodies_.slots) setVertexMass(bodies_, slot, masses_[slot]);
}

void DampedMotion::go(double drag, std::uint64_t evaluations) {
  std::ranges::fill(drag_, std::min(drag, 1.0));
  for (std::uint64_t i = 0; i < evaluations; ++i) evaluate();
}

std::uint64_t DampedMotion::goToRest(double drag, double residual, std::uint64_t most) {
  std::uint64_t made = 0;
  while (made < most && !(measureResidual(world_) <= residual)) {
    for (int slot : bodies_.slots) drag_[slot] = power_[slot] < 0 ? 2 : drag;
    evaluate();
    ++made;
  }
  return made;
}

void DampedMotion::evaluate() {
  const bool anew = made_++ % inertiaEvery == 0;
  followStiffness(anew);
  followInertia(world_, hardening_, factor_, anew);
  movePhysics(world_, interval_);
  checkBodies(world_);
  const PhysicsKernels& kernels = physicsKernels(world_.execution.isa, bodies_.parameters.precision);
  parallelFor(bodies_.blockCount(), world_.execution.threads, [&](int i) {
    const BlockView block = bodies_.block(i, threadNumber());
    const std::size_t first = std::size_t(i) * blockLanes;
    kernels.dampMotion(bodies_.meshAt(block.meshLevel).view(), block,
                       {&maxMove_[first], &drag_[first], &power_[first], &stiffness_[first]}, interval_);
  });
}

/// Gives more inertia to a cell whose own motion meets more stiffness than its limits say, as where its membrane has
/// folded. It would oscillate from evaluation to evaluation.
void DampedMotion::followStiffness(bool anew) {
  for (int slot : bodies_.slots) {
    strain_[slot] = strainDecay * strain_[slot] + (stiffness_[slot] > stiffest ? 1 : 0);
    const double factor = interval_ * interval_ * (1 + inertiaPerStrain * strain_[slot]);
    if (!anew && factor <= clearlyMore * factor_[slot]) continue;
    factor_[slot] = factor;
    hardening_[slot / blockLanes] = 0;  // inertia follows
  }
}

double DampedMotion::energy() const {
  double sum = 0;
  for (int slot : bodies_.slots) sum += measureKineticEnergy(bodies_, slot);
  return sum;
}

}  // namespace morula
