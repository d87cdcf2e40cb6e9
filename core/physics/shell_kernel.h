#pragma once
// The egg shell: a vertex outside is moved to it and loses its outward velocity, so it slides [Nilsson 2008, §4.2].
//
// Ellipsoid: q(x) = Σ (x_i/a_i)² ≤ 1, gradient g = 2 (x_i/a_i²). Two Newton steps x −= (q − 1)/|g|² g go along the
// gradient, to almost the nearest point; the last scaling by 1/√q puts the vertex on the shell to rounding.
// A sphere needs the scaling only: there it is the nearest point.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

template <bool sphere>
inline void keepInShell(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const Vec inverseSquare{Lanes(1 / (p.semiAxes[0] * p.semiAxes[0])), Lanes(1 / (p.semiAxes[1] * p.semiAxes[1])),
                          Lanes(1 / (p.semiAxes[2] * p.semiAxes[2]))};
  // Half the gradient of q.
  const auto slope = [&](const Vec& x) {
    return Vec{x.x * inverseSquare.x, x.y * inverseSquare.y, x.z * inverseSquare.z};
  };
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec x = loadVec(b.position, v, lane);
      const Mask outside = dot(x, slope(x)) > Lanes(1.0);
      if (!any(outside)) continue;
      Vec s = slope(x);
      if constexpr (!sphere)
        for (int turn = 0; turn < 2; ++turn) {
          const Lanes excess = dot(x, s) - 1.0;
          x = x - (0.5 * excess / dot(s, s)) * s;  // (q − 1)/|2s|² · 2s
          s = slope(x);
        }
      const Lanes scale = 1.0 / squareRoot(dot(x, s));
      x = scale * x;
      s = slope(x);
      const Lanes steepness = dot(s, s);
      const auto slide = [&](double* velocity) {
        const Vec u = loadVec(velocity, v, lane);
        const Vec kept = u - (larger(dot(u, s), Lanes(0.0)) / steepness) * s;
        storeVec(velocity, v, lane,
                 {select(outside, kept.x, u.x), select(outside, kept.y, u.y), select(outside, kept.z, u.z)});
      };
      const Vec before = loadVec(b.position, v, lane);
      storeVec(b.position, v, lane,
               {select(outside, x.x, before.x), select(outside, x.y, before.y), select(outside, x.z, before.z)});
      slide(b.velocity);
      slide(b.predicted);
    }
}

}  // namespace morula::MORULA_ISA
