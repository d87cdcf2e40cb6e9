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
  TimedStage driftVelocityVerlet, kickVelocityVerlet;
  TimedStage driftThesisVerlet, kickThesisVerlet;
  Stage keepInSphere, keepInEllipsoid, slideOnShell;
  Stage findSpringCoefficients, findDampedSpringCoefficients;
  Stage gatherRings;
  Stage addPressureForces, addPressureAndDragForces;
};

const PhysicsKernels& physicsKernels(Isa isa, Precision precision = Precision::binary64);

}  // namespace morula
