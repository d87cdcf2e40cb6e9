#include "physics/stages.h"

namespace morula {

namespace {

ShellShape shapeOf(const std::optional<ShellParameters>& shell) {
  if (!shell) return ShellShape::none;
  const double* a = shell->semiAxes;
  return a[0] == a[1] && a[1] == a[2] ? ShellShape::sphere : ShellShape::ellipsoid;
}

}  // namespace

PhysicsStages chooseStages(const PhysicsParameters& p, Isa isa) {
  const PhysicsKernels& k = physicsKernels(isa, p.precision);
  const bool thesis = p.integrator == Integrator::thesisVerlet;
  const int shape = static_cast<int>(shapeOf(p.shell));
  return {(thesis ? k.driftThesisVerlet : k.driftVelocityVerlet)[shape],
          (thesis ? k.kickThesisVerlet : k.kickVelocityVerlet)[p.shell.has_value()],
          p.membrane.damping > 0 ? k.findDampedSpringCoefficients : k.findSpringCoefficients, k.gatherRings,
          p.drag > 0 ? k.addPressureAndDragForces : k.addPressureForces};
}

void advance(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  const TemplateView mesh = bodies.meshAt(block.coarseness).view();
  const KernelParameters& p = bodies.kernelParameters;
  stages.drift(mesh, block, p, timeStep);
  stages.findSpringCoefficients(mesh, block, p);
  stages.gatherRings(mesh, block, p);
  stages.addPressureForces(mesh, block, p);
}

void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  const TemplateView mesh = bodies.meshAt(block.coarseness).view();
  stages.kick(mesh, block, bodies.kernelParameters, timeStep);
}

}  // namespace morula
