#pragma once
// The kernels of one cell's mechanics, one table per instruction set and precision. Each works on one block.
#include "base/isa.h"
#include "base/precision.h"
#include "physics/block.h"

namespace morula {

/// What a kick must know of the shell.
enum class KickShell { none, anyShape, aroundSpheres };

struct PhysicsKernels {
  using Stage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&);
  using TimedStage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&,
                              double timeStep);
  TimedStage driftVelocityVerlet[4], driftThesisVerlet[4];    // [ShellShape]
  TimedStage driftExplicitEuler[4], driftSymplecticEuler[4];  // [ShellShape]
  TimedStage driftRungeKutta[4][4];                           // [ShellShape][evaluation]
  TimedStage driftXpbd[2][3];                                 // [damped][ShellShape], not around spheres
  TimedStage endAndDrift[2][3];  // [dragged][ShellShape], not around spheres; velocity Verlet only
  TimedStage endEvaluation[3], kickVelocityVerlet[3], kickSymplecticEuler[3];  // [KickShell]
  Stage findTensions, findDampedTensions;
  Stage accumulateRings, accumulateAreaVectors;  // with spring forces, and without
  Stage addPressureForces, addPressureAndDragForces, findPressure;
  Stage findShapeForces[2][2];  // [damped or dragged][volumes too]
  Stage measureSpheres, measureDraggedSpheres;
};

const PhysicsKernels& physicsKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
