#pragma once
// The egg shell: a vertex outside is moved to it and loses its outward velocity, so it slides [Nilsson 2008,
// §4.2]. After the kick a vertex on the shell loses its outward acceleration too: the shell bears that force.
//
// Ellipsoid: q(x) = Σ (x_i/a_i)² ≤ 1, gradient g = 2 (x_i/a_i²). A Newton step x −= (q − 1)/|g|² g goes along
// the gradient, to almost the nearest point, and scaling by 1/√q puts the vertex on the shell to rounding. (A
// second Newton step would lead farther from the nearest point.) A sphere needs the scaling only: there it is
// the nearest point.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct ShellSlope {
  explicit ShellSlope(const KernelParameters& p)
      : inverseSquare{1 / (p.semiAxes[0] * p.semiAxes[0]), 1 / (p.semiAxes[1] * p.semiAxes[1]),
                      1 / (p.semiAxes[2] * p.semiAxes[2])} {}
  /// Half the gradient of q; x·slope(x) = q.
  MORULA_INLINE Vec operator()(const Vec& x) const {
    return {x.x * inverseSquare[0], x.y * inverseSquare[1], x.z * inverseSquare[2]};
  }
  double inverseSquare[3];
};

/// Removes the outward part of a vector that belongs to vertex v, in the lanes of `where`.
MORULA_INLINE void removeOutward(Real* array, int v, int lane, const Vec& slope, Mask where) {
  const Vec u = loadVec(array, v, lane);
  const Vec kept = u - (larger(dot(u, slope), Lanes(0.0)) / dot(slope, slope)) * slope;
  storeVec(array, v, lane,
           {select(where, kept.x, u.x), select(where, kept.y, u.y), select(where, kept.z, u.z)});
}

template <bool sphere>
inline void keepInShell(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec x = loadVec(b.position, v, lane);
      const Mask outside = dot(x, slope(x)) > Lanes(1.0);
      if (!any(outside)) continue;
      Vec s = slope(x);
      if constexpr (!sphere) {
        x = x - (0.5 * (dot(x, s) - 1.0) / dot(s, s)) * s;  // (q − 1)/|2s|² · 2s
        s = slope(x);
      }
      const Lanes scale = 1.0 / squareRoot(dot(x, s));
      x = scale * x;
      s = slope(x);
      const Vec before = loadVec(b.position, v, lane);
      storeVec(
          b.position, v, lane,
          {select(outside, x.x, before.x), select(outside, x.y, before.y), select(outside, x.z, before.z)});
      removeOutward(b.velocity, v, lane, s, outside);
      removeOutward(b.predicted, v, lane, s, outside);
    }
}

// keepInShell leaves x·slope(x) at 1 to rounding.
constexpr double onShellWithin = single ? 1e-6 : 1e-12;

/// After the kick.
inline void slideOnShell(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane), s = slope(x);
      const Mask onShell = dot(x, s) > Lanes(1.0 - onShellWithin);
      if (!any(onShell)) continue;
      removeOutward(b.velocity, v, lane, s, onShell);
      removeOutward(b.acceleration, v, lane, s, onShell);
    }
}

}  // namespace morula::MORULA_ISA
