#pragma once
// The egg shell: a vertex outside is moved to it and loses its outward velocity, so it slides [Nilsson 2008,
// §4.2]. After the kick a vertex on the shell loses its outward acceleration too: the shell bears that force.
//
// Ellipsoid: q(x) = Σ (x_i/a_i)² ≤ 1, gradient g = 2 (x_i/a_i²). A Newton step x −= (q − 1)/|g|² g goes along the
// gradient, to almost the nearest point, and scaling by 1/√q puts the vertex on the shell to rounding. (A second Newton
// step would lead farther from the nearest point.) A sphere needs the scaling only: there it is the nearest point.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct ShellSlope {
  explicit ShellSlope(const KernelParameters& p)
      : inverseSquare{1 / (p.semiAxes[0] * p.semiAxes[0]), 1 / (p.semiAxes[1] * p.semiAxes[1]),
                      1 / (p.semiAxes[2] * p.semiAxes[2])} {}
  /// Returns half the gradient of q: x·slope(x) = q.
  MORULA_INLINE Vec operator()(const Vec& x) const {
    return {x.x * inverseSquare[0], x.y * inverseSquare[1], x.z * inverseSquare[2]};
  }
  double inverseSquare[3];
};

/// The ellipsoid as cells feel it: in each lane the half-axes are longer by `more` [length]. For a ball's centre they
/// are shorter by its radius; for a mesh's vertices longer by its sag, since the shell holds the surface below them.
/// Exact in a sphere. For an ellipsoid the parallel surface would be right; this one lies up to 6 % of `more` inside of
/// that (half-axes of ratio two).
struct FeltShell {
  FeltShell() = default;
  FeltShell(const KernelParameters& p, Lanes more) {
    for (int i = 0; i < 3; ++i) {
      // A ball as large as the shell stands in its middle.
      const Lanes axis = max(p.semiAxes[i] + more, Lanes(1e-9 * p.semiAxes[i]));
      inverseSquare[i] = 1.0 / (axis * axis);
    }
  }
  /// Returns the slope at x, as ShellSlope.
  MORULA_INLINE Vec operator()(const Vec& x) const {
    return {x.x * inverseSquare[0], x.y * inverseSquare[1], x.z * inverseSquare[2]};
  }
  Lanes inverseSquare[3];
};

/// The shell as the vertices of a block feel it, for each group of lanes.
template <ShellShape shape>
struct BlockShell {
  BlockShell(const BlockView&, const KernelParameters& p) : slope(p) {}
  MORULA_INLINE const ShellSlope& operator[](int) const { return slope; }
  ShellSlope slope;
};
template <>
struct BlockShell<ShellShape::surface> {
  BlockShell(const BlockView& b, const KernelParameters& p) {
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group)
      slopes[group] = FeltShell(p, load(b.sag + lane));
  }
  MORULA_INLINE const FeltShell& operator[](int group) const { return slopes[group]; }
  FeltShell slopes[blockLanes / width];
};

/// Removes the outward part of a vector, in the lanes of `where`.
MORULA_INLINE void removeOutward(Vec& u, const Vec& slope, Mask where) {
  const Vec kept = u - (max(dot(u, slope), Lanes(0.0)) / dot(slope, slope)) * slope;
  u = {select(where, kept.x, u.x), select(where, kept.y, u.y), select(where, kept.z, u.z)};
}

/// Keeps one vertex in the shell, after the drift.
template <ShellShape shape, class Slope>
MORULA_INLINE void keepInShell(const Slope& slope, Vec& x, Vec& velocity, Vec& predicted) {
  const Mask outside = dot(x, slope(x)) > Lanes(1.0);
  if (!any(outside)) return;
  Vec y = x, s = slope(x);
  if constexpr (shape != ShellShape::sphere) {
    y = y - (0.5 * (dot(y, s) - 1.0) / dot(s, s)) * s;  // (q − 1)/|2s|² · 2s
    s = slope(y);
  }
  const Lanes scale = 1.0 / sqrt(dot(y, s));
  y = scale * y;
  s = slope(y);
  x = {select(outside, y.x, x.x), select(outside, y.y, x.y), select(outside, y.z, x.z)};
  removeOutward(velocity, s, outside);
  removeOutward(predicted, s, outside);
}

// keepInShell leaves x·slope(x) at 1 to rounding.
constexpr double onShellWithin = single ? 1e-6 : 1e-12;

MORULA_INLINE Mask isOnShell(const Vec& x, const Vec& s) { return dot(x, s) > Lanes(1.0 - onShellWithin); }

/// Lets one vertex slide on the shell, after the kick.
template <class Slope>
MORULA_INLINE void slideOnShell(const Slope& slope, const Vec& x, Vec& velocity, Vec& acceleration) {
  const Vec s = slope(x);
  const Mask onShell = isOnShell(x, s);
  if (!any(onShell)) return;
  removeOutward(velocity, s, onShell);
  removeOutward(acceleration, s, onShell);
}

}  // namespace morula::MORULA_ISA
