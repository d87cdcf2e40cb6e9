#pragma once
// The egg shell: what stands outside is moved to it and loses its outward velocity, so it slides [Nilsson 2008,
// §4.2]. After the kick what lies on the shell loses its outward acceleration too: the shell bears that force.
//
// Ellipsoid: q(x) = Σ (x_i/a_i)² ≤ 1, gradient g = 2 (x_i/a_i²). A Newton step x −= (q − 1)/|g|² g goes along
// the gradient, to almost the nearest point, and scaling by 1/√q puts the point on the shell to rounding. (A
// second Newton step would lead farther from the nearest point.) A sphere needs the scaling only: there it is
// the nearest point.
//
// Which points those are: shell_surface_kernel.h. It walks them; a shell is a struct like these, made anew for
// each group of cells, with
//   isNear(x)                      outside, or on the shell to rounding
//   keep(y, velocity, predicted)   one point after the drift; returns which lanes it moved
//   bear(y, velocity, force)       one point after the kick, which isNear
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

// keep leaves x·slope(x) at 1 to rounding.
constexpr double onShellWithin = single ? 1e-6 : 1e-12;

MORULA_INLINE Vec select(Mask where, const Vec& a, const Vec& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}

/// Removes the outward part of a vector, in the lanes of `where`.
MORULA_INLINE void removeOutward(Vec& u, const Vec& slope, Mask where) {
  u = select(where, u - (max(dot(u, slope), Lanes(0.0)) / dot(slope, slope)) * slope, u);
}

/// `Slope`: half the gradient of q; x·slope(x) = q.
template <ShellShape shape, class Slope>
struct QuadricShell {
  /// dᵀAd
  MORULA_INLINE Lanes bend(const Vec& d) const {
    if constexpr (shape == ShellShape::sphere) return slope.inverseSquare[0] * dot(d, d);
    else return dot(d, slope(d));
  }
  MORULA_INLINE Mask isNear(const Vec& x) const { return dot(x, slope(x)) > Lanes(1.0 - onShellWithin); }

  MORULA_INLINE Mask keep(Vec& y, Vec& velocity, Vec& predicted) const {
    Vec kept = y, s = slope(y);
    const Mask outside = dot(y, s) > Lanes(1.0);
    if (!any(outside)) return outside;
    if constexpr (shape == ShellShape::ellipsoid) {
      kept = kept - (0.5 * (dot(kept, s) - 1.0) / dot(s, s)) * s;  // (q − 1)/|2s|² · 2s
      s = slope(kept);
    }
    const Lanes scale = 1.0 / sqrt(dot(kept, s));
    kept = scale * kept;
    s = slope(kept);
    y = select(outside, kept, y);
    removeOutward(velocity, s, outside);
    removeOutward(predicted, s, outside);
    return outside;
  }

  MORULA_INLINE void bear(const Vec& y, Vec& velocity, Vec& force) const {
    const Vec s = slope(y);
    const Mask on = dot(y, s) > Lanes(1.0 - onShellWithin);
    removeOutward(velocity, s, on);
    removeOutward(force, s, on);
  }

  Slope slope;
};

struct ShellSlope {
  ShellSlope(const BlockView&, const KernelParameters& p, int)
      : inverseSquare{1 / (p.semiAxes[0] * p.semiAxes[0]), 1 / (p.semiAxes[1] * p.semiAxes[1]),
                      1 / (p.semiAxes[2] * p.semiAxes[2])} {}
  MORULA_INLINE Vec operator()(const Vec& x) const {
    return {x.x * inverseSquare[0], x.y * inverseSquare[1], x.z * inverseSquare[2]};
  }
  double inverseSquare[3];
};

struct NoShell {
  static constexpr bool isThere = false;
  NoShell(const BlockView&, const KernelParameters&, int) {}
};

/// The shell around surfaces, which sag between their vertices.
template <ShellShape shape>
struct RoundShell : QuadricShell<shape, ShellSlope> {
  static constexpr bool isThere = true, sags = true;
  RoundShell(const BlockView& b, const KernelParameters& p, int lane)
      : QuadricShell<shape, ShellSlope>{ShellSlope(b, p, lane)} {}
};

}  // namespace morula::MORULA_ISA
