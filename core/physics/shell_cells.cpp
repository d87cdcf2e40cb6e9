// Cells of a membrane of damped springs around a fluid under pressure [Nilsson 2008, §4.2].
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/maths.h"
#include "mesh/mesh_measures.h"
#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "physics/stability.h"
#include "physics/stages.h"

namespace morula {
namespace {

void chooseShellForces(PhysicsStages& s, const PhysicsKernels& k, const PhysicsParameters& p, bool) {
  if (kindOf(p.integrator).solvesForces) {
    s.accumulateRings = k.accumulateAreaVectors;
    s.finishForces = k.findPressure;
    return;
  }
  const bool damped = p.membrane.damping.acts();
  s.findTensions = p.membrane.springs != Springs::equal ? k.findWeightedTensions[damped]
                   : damped                             ? k.findDampedTensions
                                                        : k.findTensions;
  s.accumulateRings = k.accumulateRings;
  if (p.membrane.bending > 0) s.addBending = k.addBendingForces;
  s.finishForces = p.drag > 0 ? k.addPressureAndDragForces : k.addPressureForces;
  if (p.integrator == Integrator::velocityVerlet)  // null in planes, and where the shell holds surfaces
    s.endAndDrift = k.endAndDrift[p.drag > 0][static_cast<int>(shellShapeOf(p))];
}

/// Returns the largest stiffness [force/length] of bending.
double bendingStiffness(const Bodies& b, int slot) {
  return b.parameters.membrane.bending * b.meshOf(slot).bending.stiffest / (b.restScale[slot] * b.restScale[slot]);
}

/// Returns the limits of an integrator that drag alone keeps stable [stability.h]. `radius` [length]: of the sphere of
/// the cell's volume. `omega` [1/time]: of its breathing.
StabilityLimits limitsByDrag(const Bodies& b, int slot, double radius, double omega) {
  const auto& membrane = b.parameters.membrane;
  const auto oscillator = kindOf(b.parameters.integrator).oscillatorLimit;
  const double drag = b.parameters.drag, m = b.vertexMass[slot] / b.meshOf(slot).ringWeight;
  const double bending = bendingStiffness(b, slot);
  if (!(drag > 0)) return {0, 0, bending > 0 ? 0 : INFINITY};
  const Mesh& mesh = b.meshOf(slot).mesh;
  const double fourPi = 4 * std::numbers::pi;
  const double atRest = b.restScale[slot] * cubeRoot(3 * measureVolume(mesh.vertices, mesh.faces) / fourPi);
  const double tension = membrane.stiffness * std::max(1 - atRest / radius, 0.0);
  const double damping = membrane.damping.of(membrane.stiffness, b.vertexMass[slot]);
  return {std::min(oscillator(membrane.stiffness, damping + drag * m, m), oscillator(tension, drag * m, m)),
          oscillator(omega * omega, drag, 1),
          bending > 0 ? oscillator(bending, drag * b.vertexMass[slot], b.vertexMass[slot]) : INFINITY};
}

StabilityLimits shellLimits(const Bodies& b, int slot) {
  const IntegratorKind& integrator = kindOf(b.parameters.integrator);
  if (integrator.solvesForces) return {INFINITY, INFINITY, INFINITY};
  const auto& membrane = b.parameters.membrane;
  const double fourPi = 4 * std::numbers::pi, volume = b.volume[slot];
  const double radius = cubeRoot(3 * volume / fourPi), area = fourPi * radius * radius;
  const double omega = std::sqrt(b.meshOf(slot).unevenness * b.pressureConstant[slot] / b.mass(slot)) / volume * area;
  if (integrator.needsDrag) return limitsByDrag(b, slot, radius, omega);
  const double m = b.vertexMass[slot], damping = membrane.damping.of(membrane.stiffness, m);
  return {integrator.oscillatorLimit(membrane.stiffness, damping, m / b.meshOf(slot).ringWeight),
          integrator.undampedLimit / omega, integrator.undampedLimit / std::sqrt(bendingStiffness(b, slot) / m)};
}

}  // namespace

const CellModelKind shellCells{
    .hasMembrane = true, .limitedBy = "springs", .chooseForces = chooseShellForces, .limits = shellLimits};

}  // namespace morula
