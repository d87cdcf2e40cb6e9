#pragma once
// The egg shell of a convex mesh: the intersection of the half-spaces n·x ≤ d of its faces. The rules are those of
// shell_kernel.h: what the drift brings outside is moved to the shell and slides, and the shell bears what presses.
//
// A point outside is moved onto one plane after the other, x −= max(n·x − d, 0) n, a few times over: where planes meet
// at right angles once is exact, elsewhere the passes converge on the shell. Scaling by 1 / max(n·x/d) then puts it on
// the shell to rounding, whatever is left. In edges and corners it loses what is outward of each plane that it lies on.
//
// As for an ellipsoid the centre of a ball feels a shell that is smaller by the ball's radius: planes that are nearer,
// which is exact.
#include "mesh/convex_shell.h"
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

constexpr int shellPasses = 4;    // over the planes, for places
constexpr int outwardPasses = 2;  // for velocities

/// The planes as surfaces, or centres of balls, of the cells from `lane` on feel them.
template <bool balls>
struct PlaneShell {
  static constexpr bool isThere = true, sags = false;
  PlaneShell(const BlockView& b, const KernelParameters& p, int lane)
      : planes(p.planes), count(p.planeCount) {
    if constexpr (balls) radius = p.radius * load(b.restScale + lane);
  }

  MORULA_INLINE Vec normal(int i) const {
    const Vector& n = planes[i].normal;
    return {Lanes(n.x), Lanes(n.y), Lanes(n.z)};
  }
  MORULA_INLINE Lanes offset(int i) const {
    const double d = planes[i].offset;
    if constexpr (balls) return max(d - radius, Lanes(1e-9 * d));  // a ball too large stands in the middle
    return Lanes(d);
  }

  MORULA_INLINE Mask isNear(const Vec& x) const {
    Lanes nearest = -1.0;
    for (int i = 0; i < count; ++i)
      nearest = max(nearest, dot(x, normal(i)) - (1.0 - onShellWithin) * offset(i));
    return nearest > Lanes(0.0);
  }

  MORULA_INLINE Mask keep(Vec& x, Vec& velocity, Vec& predicted) const {
    Lanes excess = 0.0;
    for (int i = 0; i < count; ++i) excess = max(excess, dot(x, normal(i)) - offset(i));
    const Mask outside = excess > Lanes(0.0);
    if (!any(outside)) return outside;
    Vec y = x;
    for (int pass = 0; pass < shellPasses; ++pass)
      for (int i = 0; i < count; ++i) {
        const Vec n = normal(i);
        y = y - max(dot(y, n) - offset(i), Lanes(0.0)) * n;
      }
    Lanes reach = 1.0;
    for (int i = 0; i < count; ++i) reach = max(reach, dot(y, normal(i)) / offset(i));
    y = (1.0 / reach) * y;
    Vec v = velocity, w = predicted;
    bear(y, v, w);
    x = select(outside, y, x);
    velocity = select(outside, v, velocity);
    predicted = select(outside, w, predicted);
    return outside;
  }

  /// Removes what is outward of each plane that x lies on.
  MORULA_INLINE void bear(const Vec& x, Vec& u, Vec& w) const {
    for (int pass = 0; pass < outwardPasses; ++pass)
      for (int i = 0; i < count; ++i) {
        const Vec n = normal(i);
        const Mask on = dot(x, n) > (1.0 - onShellWithin) * offset(i);
        if (!any(on)) continue;
        removeOutward(u, n, on);
        removeOutward(w, n, on);
      }
  }

  const ShellPlane* planes;
  int count;
  Lanes radius = 0.0;
};

}  // namespace morula::MORULA_ISA
