#pragma once
// The part that the drifts of all integrators share: one pass over the vertices, and the shell.
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

/// Calls advance(v, lane, acceleration, x, velocity, predicted) for each vertex, from position and velocity. Then keeps
/// the vertex in the shell, and writes the last three.
template <ShellShape shell, class Advance>
MORULA_INLINE void driftVertices(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                                 const Advance& advance) {
  const BlockShell<shell> felt(b, p);
  Real *position = b.position, *velocities = b.velocity, *predictions = b.predicted;
  const Real* accelerations = b.acceleration;
  const int vertices = mesh.vertexCount, liveLanes = b.liveLanes;
  for (int v = 0; v < vertices; ++v)
    for (int lane = 0, group = 0; lane < liveLanes; lane += width, ++group) {
      Vec x = loadVec(position, v, lane), velocity = loadVec(velocities, v, lane), predicted;
      advance(v, lane, loadVec(accelerations, v, lane), x, velocity, predicted);
      if constexpr (shell != ShellShape::none) keepInShell<shell>(felt[group], x, velocity, predicted);
      storeVec(velocities, v, lane, velocity);
      storeVec(predictions, v, lane, predicted);
      storeVec(position, v, lane, x);
    }
}

// Attribute before the body of a lambda that a kernel calls.
#define MORULA_INLINE_LAMBDA __attribute__((always_inline))

}  // namespace morula::MORULA_ISA
