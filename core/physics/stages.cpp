#include "physics/stages.h"

namespace morula {

PhysicsStages chooseStages(const PhysicsParameters& p, Isa isa) {
  const PhysicsKernels& k = physicsKernels(isa, p.precision);
  const bool thesis = p.integrator == Integrator::thesisVerlet;
  const double* a = p.shell ? p.shell->semiAxes : nullptr;
  const bool sphere = a && a[0] == a[1] && a[1] == a[2];
  return {thesis ? k.driftThesisVerlet : k.driftVelocityVerlet,
          thesis ? k.kickThesisVerlet : k.kickVelocityVerlet,
          !a       ? nullptr
          : sphere ? k.keepInSphere
                   : k.keepInEllipsoid,
          a ? k.slideOnShell : nullptr,
          p.membrane.damping > 0 ? k.findDampedSpringCoefficients : k.findSpringCoefficients,
          k.gatherRings,
          p.drag > 0 ? k.addPressureAndDragForces : k.addPressureForces};
}

void advance(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  const TemplateView mesh = bodies.meshAt(block.coarseness).view();
  const KernelParameters& p = bodies.kernelParameters;
  stages.drift(mesh, block, p, timeStep);
  if (stages.keepInShell) stages.keepInShell(mesh, block, p);
  stages.findSpringCoefficients(mesh, block, p);
  stages.gatherRings(mesh, block, p);
  stages.addPressureForces(mesh, block, p);
}

void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  const TemplateView mesh = bodies.meshAt(block.coarseness).view();
  stages.kick(mesh, block, bodies.kernelParameters, timeStep);
  if (stages.slideOnShell) stages.slideOnShell(mesh, block, bodies.kernelParameters);
}

}  // namespace morula
