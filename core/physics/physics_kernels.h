#pragma once
// The kernels of one cell's mechanics, one table per instruction set and precision. Each works on one block.
#include "base/isa.h"
#include "base/precision.h"
#include "physics/block.h"

namespace morula {

/// The kind of shell that a kick is compiled for.
enum class KickShell { none, anyShape, surface, aroundSpheres, planes, planesAroundSpheres };

/// The state of a damped motion for a block's cells, [lane] (relax_kernel.h).
struct MotionDamping {
  const double* maxMove;  // [length] max move of any vertex in one evaluation
  const double* drag;     // [1] η
  double* power;          // [length²/time³] Σ v½·a, with the velocity that this evaluation leaves
  double* stiffness;      // [1] σ of the motion before this evaluation
};

struct PhysicsKernels {
  using Stage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&);
  using TimedStage = void (*)(const TemplateView&, const BlockView&, const KernelParameters&, double timeStep);
  TimedStage driftVelocityVerlet[7], driftThesisVerlet[7];    // [ShellShape]
  TimedStage driftExplicitEuler[7], driftSymplecticEuler[7];  // [ShellShape]
  TimedStage driftRungeKutta[7][4];                           // [ShellShape][evaluation]
  TimedStage driftXpbd[2][6];                                 // [damped][ShellShape], null around spheres
  // [dragged][ShellShape], null around spheres and in planes; velocity Verlet only
  TimedStage endAndDrift[2][6];
  TimedStage endEvaluation[6], kickVelocityVerlet[6], kickSymplecticEuler[6];  // [KickShell]
  Stage findTensions, findDampedTensions;
  Stage findWeightedTensions[2];                 // [damped]
  Stage accumulateRings, accumulateAreaVectors;  // with spring forces, and without
  Stage addBendingForces;
  Stage addPressureForces, addPressureAndDragForces, findPressure;
  Stage findShapeForces[2][2];  // [damped or dragged][volumes too]
  Stage measureSpheres, measureDraggedSpheres;
  void (*dampMotion)(const TemplateView&, const BlockView&, const MotionDamping&, double interval);
};

const PhysicsKernels& physicsKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
