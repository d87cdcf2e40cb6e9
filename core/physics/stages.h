#pragma once
// The stages of one block's step, in the order of the thesis' figure 4.4.
#include <span>

#include "physics/bodies.h"
#include "physics/physics_kernels.h"

namespace morula {

/// A stage that does nothing, for what the scene leaves out.
inline void noOp(const TemplateView&, const BlockView&, const KernelParameters&) {}

/// The kernels that a scene's parameters call for, chosen once; none computes what the scene lacks.
struct PhysicsStages {
  PhysicsKernels::TimedStage drift, kick;
  // The drifts of the second to fourth evaluation in a step of Runge–Kutta; other integrators have none.
  std::span<const PhysicsKernels::TimedStage> furtherDrifts;

  // The inner forces, in this order
  PhysicsKernels::Stage findTensions = noOp;     // per edge: coefficient ← spring force over edge vector
  PhysicsKernels::Stage accumulateRings = noOp;  // per one-ring: gradient, volume; acceleration ← springs
  PhysicsKernels::Stage addBending = noOp;       // acceleration += bending
  PhysicsKernels::Stage finishForces = noOp;     // all other forces, and the pressure; acceleration ← whole force

  // finishForces, the kick and the next step's drift in one, for isolated cells; null where there is no such kernel.
  PhysicsKernels::TimedStage endAndDrift = nullptr;
};

/// Chooses the kernels. `surfaces`: contacts need area vectors at each evaluation; springs with gas have them anyway.
PhysicsStages chooseStages(const PhysicsParameters& parameters, Isa isa, bool surfaces = true);

/// Returns the narrowest instruction set up to `widest` that takes this many cells in one go: a block with few cells
/// does not pay for empty lanes. All sets give the same bits.
Isa narrowestIsa(int cells, Isa widest, Precision precision);

/// Returns the egg shell's shape as this model's vertices feel it.
ShellShape shellShapeOf(const PhysicsParameters& parameters);

/// Moves a block on by `timeStep` and leaves its inner forces in `acceleration`. A `timeStep` of 0 moves nothing.
void advance(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

/// Returns the stages of one further evaluation of the same time step.
PhysicsStages furtherStages(const PhysicsStages& stages, std::size_t evaluation);

/// Turns forces into accelerations and ends the time step, once the outer forces are added.
void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

/// True for a positive volume and a pressure that both lie below the largest sensible number.
inline bool isSound(double volume, double pressure) {
  // These comparisons fail for NaN.
  return volume > 0 && volume < 1e300 && pressure < 1e300;
}

/// Takes `steps` whole time steps of a block of isolated cells, on which nothing else acts, while the block stays in
/// cache: the same bits as advance and kick. Returns false at once when a cell is not sound (isSound) after a step; the
/// block's state is then of no use.
bool stepIsolatedCells(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep,
                       std::uint64_t steps);

}  // namespace morula
