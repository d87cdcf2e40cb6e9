#pragma once
// The stages of one block's step, in the order of the thesis' figure 4.4.
#include <span>

#include "physics/bodies.h"
#include "physics/physics_kernels.h"

namespace morula {

/// The kernels that a scene's parameters call for, chosen once: none does what the scene has not.
struct PhysicsStages {
  PhysicsKernels::TimedStage drift, kick;
  // Of the evaluations after the first in a time step: Runge–Kutta's second to fourth; none elsewhere.
  std::span<const PhysicsKernels::TimedStage> furtherDrifts;
  PhysicsKernels::Stage findSpringCoefficients, gatherRings, addPressureForces;
};

/// `surfaces`: whether somebody, contacts, needs the vertices' area vectors of each evaluation. Springs with
/// gas have them anyway.
PhysicsStages chooseStages(const PhysicsParameters& parameters, Isa isa, bool surfaces = true);

/// The narrowest of the instruction sets up to `widest` that takes so many cells in one go: a block with few
/// cells does not pay for empty lanes. The same bits as any.
Isa narrowestIsa(int cells, Isa widest, Precision precision);

/// Moves a block on by `timeStep` and evaluates its inner forces, which then stand in `acceleration`. 0 only
/// evaluates.
void advance(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

/// The stages of one further evaluation of the same time step.
PhysicsStages furtherStages(const PhysicsStages& stages, std::size_t evaluation);

/// Once the outer forces are added: turns forces into accelerations and ends the time step.
void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep);

}  // namespace morula
