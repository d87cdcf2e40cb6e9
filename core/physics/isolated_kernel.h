#pragma once
// Isolated cells: the end of one time step and the drift of the next in one pass. Between the two no other
// force is added, so accelerations need not be stored, and velocities are read and written once, not twice.
#include "physics/pressure_kernel.h"
#include "physics/verlet_kernel.h"

namespace morula::MORULA_ISA {

/// Runs velocity Verlet's addPressureForces, kick<Kick::half> and driftVelocityVerlet, bit for bit. Leaves forces in
/// `acceleration`: the last of several steps ends with these three kernels.
template <bool dragged, ShellShape shell>
inline void endAndDrift(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const EnclosedFluid<dragged> fluid(b, p);
  const Lanes halfStep = 0.5 * dt, step = dt;
  const InverseMass inverseMass(b);
  const BlockShell<shell> felt(b, p);
  Real *position = b.position, *velocities = b.velocity, *predictions = b.predicted;
  const int vertices = mesh.vertexCount, liveLanes = b.liveLanes;
  for (int v = 0; v < vertices; ++v)
    for (int lane = 0, group = 0; lane < liveLanes; lane += width, ++group) {
      Vec x = loadVec(position, v, lane), velocity = loadVec(velocities, v, lane), predicted;
      const Vec a = kickVertex<Kick::half, shell != ShellShape::none>(
          felt[group], load(inverseMass.value + lane), halfStep, fluid.forceWith(v, lane, group), x, velocity);
      driftVertex(halfStep, step, a, x, velocity, predicted);
      if constexpr (shell != ShellShape::none) keepInShell<shell>(felt[group], x, velocity, predicted);
      storeVec(velocities, v, lane, velocity);
      storeVec(predictions, v, lane, predicted);
      storeVec(position, v, lane, x);
    }
}

}  // namespace morula::MORULA_ISA
