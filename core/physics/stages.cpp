#include "physics/stages.h"

#include "physics/cell_model.h"
#include "physics/integrator.h"

namespace morula {

ShellShape shellShapeOf(const PhysicsParameters& p) {
  if (!p.shell) return ShellShape::none;
  const bool balls = !kindOf(p.cell.model).hasMesh;
  if (p.shell->mesh) return balls ? ShellShape::planesAroundSpheres : ShellShape::planes;
  if (balls) return ShellShape::aroundSpheres;
  if (p.shell->holds == Held::surface) return ShellShape::surface;
  const double* a = p.shell->semiAxes.data();
  return a[0] == a[1] && a[1] == a[2] ? ShellShape::sphere : ShellShape::ellipsoid;
}

PhysicsStages chooseStages(const PhysicsParameters& p, Isa isa, bool surfaces) {
  const PhysicsKernels& k = physicsKernels(isa, p.precision);
  const ShellShape shape = shellShapeOf(p);
  const KickShell kickShell = shape == ShellShape::none                  ? KickShell::none
                              : shape == ShellShape::surface             ? KickShell::surface
                              : shape == ShellShape::aroundSpheres       ? KickShell::aroundSpheres
                              : shape == ShellShape::planes              ? KickShell::planes
                              : shape == ShellShape::planesAroundSpheres ? KickShell::planesAroundSpheres
                                                                         : KickShell::anyShape;
  const Movement move = kindOf(p.integrator).movement(k, static_cast<int>(shape), p.membrane.damping.acts());
  PhysicsStages stages{
      .drift = move.drift, .kick = move.kick[static_cast<int>(kickShell)], .furtherDrifts = move.furtherDrifts};
  kindOf(p.cell.model).chooseForces(stages, k, p, surfaces);
  return stages;
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
  const TemplateView mesh = bodies.meshAt(block.meshLevel).view();
  const KernelParameters& p = bodies.kernelParameters;
  stages.drift(mesh, block, p, timeStep);
  stages.findTensions(mesh, block, p);
  stages.accumulateRings(mesh, block, p);
  stages.addBending(mesh, block, p);
  stages.finishForces(mesh, block, p);
}

void kick(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  const TemplateView mesh = bodies.meshAt(block.meshLevel).view();
  stages.kick(mesh, block, bodies.kernelParameters, timeStep);
}

namespace {

bool areSound(const BlockView& block) {
  for (int lane = 0; lane < block.liveLanes; ++lane)
    if (!isSound(block.volume[lane], block.pressure[lane])) return false;
  return true;
}

/// Takes a time step with all its evaluations.
void stepOnce(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep) {
  advance(stages, bodies, block, timeStep);
  kick(stages, bodies, block, timeStep);
  for (std::size_t i = 0; i < stages.furtherDrifts.size(); ++i) {
    const PhysicsStages further = furtherStages(stages, i);
    advance(further, bodies, block, timeStep);
    kick(further, bodies, block, timeStep);
  }
}

}  // namespace

bool stepIsolatedCells(const PhysicsStages& stages, const Bodies& bodies, const BlockView& block, double timeStep,
                       std::uint64_t steps) {
  const TemplateView mesh = bodies.meshAt(block.meshLevel).view();
  const KernelParameters& p = bodies.kernelParameters;
  if (stages.endAndDrift && steps > 1) {
    stages.drift(mesh, block, p, timeStep);
    for (;; --steps) {
      stages.findTensions(mesh, block, p);
      stages.accumulateRings(mesh, block, p);
      stages.addBending(mesh, block, p);
      if (steps == 1) break;
      stages.endAndDrift(mesh, block, p, timeStep);
      if (!areSound(block)) return false;
    }
    stages.finishForces(mesh, block, p);
    stages.kick(mesh, block, p, timeStep);
    return areSound(block);
  }
  for (; steps > 0; --steps) {
    stepOnce(stages, bodies, block, timeStep);
    if (!areSound(block)) return false;
  }
  return true;
}

}  // namespace morula
