#pragma once
// Of isolated cells: the end of one time step and the drift of the next in one pass. Between the two no other
// force is added, so accelerations need not be stored, and velocities are read and written once, not twice.
#include "physics/pressure_kernel.h"
#include "physics/shell_surface_kernel.h"
#include "physics/verlet_kernel.h"

namespace morula::MORULA_ISA {

/// Velocity Verlet's addPressureForces, kick<Kick::half> and driftVelocityVerlet, bit for bit, with the shell's part in
/// both. Leaves forces in `acceleration`: the last of several steps ends with those three.
template <bool dragged, class Shell>
inline void endAndDrift(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const EnclosedFluid<dragged> fluid(b, p);
  const Lanes halfStep = 0.5 * dt, step = dt;
  const InverseMass inverseMass(b);
  const Shell shell(b, p, 0);  // the same in all lanes
  Real *position = b.position, *velocities = b.velocity, *predictions = b.predicted;
  const int vertices = mesh.vertexCount, liveLanes = b.liveLanes;
  for (int v = 0; v < vertices; ++v)
    for (int lane = 0, group = 0; lane < liveLanes; lane += width, ++group) {
      Vec x = loadVec(position, v, lane), velocity = loadVec(velocities, v, lane), predicted;
      Vec a = kickVertex<Kick::half>(load(inverseMass.value + lane), halfStep,
                                     fluid.forceWith(v, lane, group), velocity);
      if constexpr (Shell::isThere) {
        const Vec y = loadVec(b.held, v, lane);
        if (any(shell.isNear(y))) shell.bear(y, velocity, a);
      }
      driftVertex(halfStep, step, a, x, velocity, predicted);
      storeVec(velocities, v, lane, velocity);
      storeVec(predictions, v, lane, predicted);
      storeVec(position, v, lane, x);
    }
  if constexpr (Shell::isThere) keepInShell<Shell>(mesh, b, p);
}

}  // namespace morula::MORULA_ISA
