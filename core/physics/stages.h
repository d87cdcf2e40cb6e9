#pragma once
// The stages of one block's step, in the order of the thesis' figure 4.4.
#include <span>

#include "physics/bodies.h"
#include "physics/physics_kernels.h"

namespace morula {

/// A stage that does nothing, for what the scene leaves out.
inline void noOp(const TemplateView&, const BlockView&, const KernelParameters&) {}

/// The kernels that a scene's parameters call for, chosen once: none does what the scene has not.
struct PhysicsStages {
  PhysicsKernels::TimedStage drift, kick;
  // The drifts of the second to fourth evaluation in a step of Runge–Kutta; other integrators have none.
  std::span<const PhysicsKernels::TimedStage> furtherDrifts;

  // The inner forces, in this order
  PhysicsKernels::Stage findTensions = noOp;     // of each edge: coefficient ← spring force over edge vector
  PhysicsKernels::Stage accumulateRings = noOp;  // of each one-ring: gradient, volume; acceleration ← springs
  PhysicsKernels::Stage finishForces = noOp;     // all others, and the pressure; acceleration ← whole force

  // finishForces, the kick and the next step's drift in one, for isolated cells; null where there is no such kernel.
  PhysicsKernels::TimedStage endAndDrift = nullptr;
};

/// `surfaces`: whether contacts need the vertices' area vectors of each evaluation. Springs with gas have them anyway.
PhysicsStages chooseStages(const PhysicsParameters& parameters, Isa isa, bool surfaces = true);

/// The narrowest of the instruction sets up to `widest` that takes so many cells in one go: a block with few
/// cells does not pay for empty lanes. The same bits as any.
Isa narrowestIsa(int cells, Isa widest, Precision precision);

/// The egg shell as this model's vertices feel it.
ShellShape shellShapeOf(const PhysicsParameters& parameters);

/// Moves a block on by `timeStep` and evaluates its inner forces, which then stand in `acceleration`. With 0
/// nothing moves.
void advance(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

/// The stages of one further evaluation of the same time step.
PhysicsStages furtherStages(const PhysicsStages& stages, std::size_t evaluation);

/// Once the outer forces are added: turns forces into accelerations and ends the time step.
void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

/// True unless the volume is not a positive number below the largest sensible one, or so with the pressure.
inline bool isSound(double volume, double pressure) {
  // Written so that a NaN fails: it does not compare.
  return volume > 0 && volume < 1e300 && pressure < 1e300;
}

/// So many whole time steps of a block of isolated cells, on which nothing else acts, while it stays in cache:
/// the same bits as advance and kick. False at once when a cell is not sound (isSound) after a step; the
/// block's state is then of no use.
bool stepIsolatedCells(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep,
                       std::uint64_t steps);

}  // namespace morula
