#pragma once
// The kernels of one cell's mechanics, one table per instruction set and precision. Each works on one block.
#include "base/isa.h"
#include "base/precision.h"
#include "physics/block.h"

namespace morula {

struct PhysicsKernels {
  using Stage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&);
  using TimedStage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&,
                              double timeStep);
  TimedStage driftVelocityVerlet[3], driftThesisVerlet[3];                     // [ShellShape]
  TimedStage driftExplicitEuler[3], driftSymplecticEuler[3];                   // [ShellShape]
  TimedStage driftRungeKutta[3][4];                                            // [ShellShape][evaluation]
  TimedStage driftXpbd[2][3];                                                  // [damped][ShellShape]
  TimedStage endEvaluation[2], kickVelocityVerlet[2], kickSymplecticEuler[2];  // [is there a shell]
  Stage findSpringCoefficients, findDampedSpringCoefficients;
  Stage gatherRings, gatherRingsWithoutSprings;
  Stage addPressureForces, addPressureAndDragForces, findPressure;
  Stage findShapeForces[2][2];  // [damped or dragged][volumes too]
};

const PhysicsKernels& physicsKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
