#pragma once
// What the drifts of all integrators share: one pass over the vertices, and the shell.
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

/// For each vertex advance(v, lane, x, velocity, predicted), from position and velocity; and the shell keeps
/// what would leave it. Writes all three.
template <ShellShape shell, class Advance>
MORULA_INLINE void driftVertices(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                                 const Advance& advance) {
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec x = loadVec(b.position, v, lane), velocity = loadVec(b.velocity, v, lane), predicted;
      advance(v, lane, x, velocity, predicted);
      if constexpr (shell != ShellShape::none) keepInShell<shell>(slope, x, velocity, predicted);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.predicted, v, lane, predicted);
      storeVec(b.position, v, lane, x);
    }
}

// In front of the body of a lambda that a kernel calls.
#define MORULA_INLINE_LAMBDA __attribute__((always_inline))

}  // namespace morula::MORULA_ISA
