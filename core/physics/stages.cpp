#include "physics/stages.h"

namespace morula {

namespace {

ShellShape shapeOf(const PhysicsParameters& p) {
  if (!p.shell) return ShellShape::none;
  if (p.cell.model == CellModel::sphere) return ShellShape::aroundSpheres;
  const double* a = p.shell->semiAxes;
  return a[0] == a[1] && a[1] == a[2] ? ShellShape::sphere : ShellShape::ellipsoid;
}

/// Where a model has no such stage.
void nothing(const TemplateView&, const BlockView&, const KernelParameters&) {}

KickShell kickShellOf(ShellShape shape) {
  if (shape == ShellShape::none) return KickShell::none;
  return shape == ShellShape::aroundSpheres ? KickShell::aroundSpheres : KickShell::anyShape;
}

struct Movement {
  PhysicsKernels::TimedStage drift;
  const PhysicsKernels::TimedStage* kick;  // [KickShell]
  std::span<const PhysicsKernels::TimedStage> furtherDrifts;
};

Movement movementOf(const PhysicsKernels& k, const PhysicsParameters& p, int shape) {
  switch (p.integrator) {
    case Integrator::velocityVerlet:
      return {k.driftVelocityVerlet[shape], k.kickVelocityVerlet, {}};
    case Integrator::thesisVerlet:
      return {k.driftThesisVerlet[shape], k.endEvaluation, {}};
    case Integrator::explicitEuler:
      return {k.driftExplicitEuler[shape], k.endEvaluation, {}};
    case Integrator::symplecticEuler:
      return {k.driftSymplecticEuler[shape], k.kickSymplecticEuler, {}};
    case Integrator::rungeKutta4:
      return {k.driftRungeKutta[shape][0], k.endEvaluation, std::span(k.driftRungeKutta[shape]).subspan(1)};
    case Integrator::xpbd:
      return {k.driftXpbd[p.membrane.damping > 0][shape], k.endEvaluation, {}};
  }
  return {};
}

}  // namespace

PhysicsStages chooseStages(const PhysicsParameters& p, Isa isa, bool surfaces) {
  const PhysicsKernels& k = physicsKernels(isa, p.precision);
  const ShellShape shape = shapeOf(p);
  const Movement move = movementOf(k, p, static_cast<int>(shape));
  const PhysicsKernels::TimedStage kick = move.kick[static_cast<int>(kickShellOf(shape))];
  if (p.cell.model == CellModel::sphere)
    return {move.drift,
            kick,
            move.furtherDrifts,
            nothing,
            p.drag > 0 ? k.measureDraggedSpheres : k.measureSpheres,
            nothing};
  if (p.integrator == Integrator::xpbd)  // its drift moves springs and contents
    return {move.drift, kick, {}, nothing, k.gatherRingsWithoutSprings, k.findPressure};
  if (p.cell.model == CellModel::shapeMatching) {
    const bool resisted = p.shapeMatching.damping > 0 || p.drag > 0;
    return {move.drift,
            kick,
            move.furtherDrifts,
            nothing,
            surfaces ? k.gatherRingsWithoutSprings : nothing,
            k.findShapeForces[resisted][!surfaces]};
  }
  return {move.drift,
          kick,
          move.furtherDrifts,
          p.membrane.damping > 0 ? k.findDampedSpringCoefficients : k.findSpringCoefficients,
          k.gatherRings,
          p.drag > 0 ? k.addPressureAndDragForces : k.addPressureForces,
          p.integrator == Integrator::velocityVerlet ? k.endAndDrift[p.drag > 0][static_cast<int>(shape)]
                                                     : nullptr};
}

Isa narrowestIsa(int cells, Isa widest, Precision precision) {
  const bool wide = precision == Precision::binary64;
  for (const Isa isa : {Isa::scalar, Isa::narrow, Isa::avx2}) {
    const int width = isa == Isa::scalar ? 1 : isa == Isa::narrow ? (wide ? 2 : 4) : (wide ? 4 : 8);
    if (isa == widest || width >= cells) return isa;
  }
  return widest;
}

PhysicsStages furtherStages(const PhysicsStages& stages, std::size_t evaluation) {
  PhysicsStages further = stages;
  further.drift = stages.furtherDrifts[evaluation];
  return further;
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

namespace {

bool areSound(const BlockView& block) {
  for (int lane = 0; lane < block.liveLanes; ++lane)
    if (!isSound(block.volume[lane], block.pressure[lane])) return false;
  return true;
}

/// A time step with all its evaluations.
void moveAlone(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  advance(stages, bodies, block, timeStep);
  kick(stages, bodies, block, timeStep);
  for (std::size_t i = 0; i < stages.furtherDrifts.size(); ++i) {
    const PhysicsStages further = furtherStages(stages, i);
    advance(further, bodies, block, timeStep);
    kick(further, bodies, block, timeStep);
  }
}

}  // namespace

bool goAlone(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep,
             std::uint64_t steps) {
  const TemplateView mesh = bodies.meshAt(block.coarseness).view();
  const KernelParameters& p = bodies.kernelParameters;
  if (stages.endAndDrift && steps > 1) {
    stages.drift(mesh, block, p, timeStep);
    for (;; --steps) {
      stages.findSpringCoefficients(mesh, block, p);
      stages.gatherRings(mesh, block, p);
      if (steps == 1) break;
      stages.endAndDrift(mesh, block, p, timeStep);
      if (!areSound(block)) return false;
    }
    stages.addPressureForces(mesh, block, p);
    stages.kick(mesh, block, p, timeStep);
    return areSound(block);
  }
  for (; steps > 0; --steps) {
    moveAlone(stages, bodies, block, timeStep);
    if (!areSound(block)) return false;
  }
  return true;
}

}  // namespace morula
