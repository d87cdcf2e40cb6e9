#pragma once
// The egg shell of a convex mesh: the intersection of the half-spaces n·x ≤ d of its faces. The rules are those of
// shell_kernel.h: a vertex outside is moved to the shell and slides, and the shell bears the forces against it.
//
// A vertex outside is moved onto one plane after the other, x −= max(n·x − d, 0) n, a few times over: where planes meet
// at right angles once is exact, elsewhere the passes converge on the shell. Scaling by 1 / max(n·x/d) then puts it on
// the shell to rounding. In edges and corners it loses the outward motion of each plane that it lies on.
//
// The centre of a ball feels a shell that is smaller by the ball's radius, as with an ellipsoid. Planes moved inwards
// by the radius describe this shell exactly.
#include "mesh/convex_shell.h"
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

constexpr int shellPasses = 4;    // passes over the planes, for places
constexpr int outwardPasses = 2;  // passes over the planes, for velocities

/// The planes as vertices, or centres of balls, feel them: those of the cells from `lane` on.
template <bool balls>
struct FeltPlanes {
  FeltPlanes(const BlockView& b, const KernelParameters& p, int lane) : planes(p.planes), count(p.planeCount) {
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
  const ShellPlane* planes;
  int count;
  Lanes radius = 0.0;
};

/// Removes from u its outward part at each plane that x lies on.
template <bool balls>
MORULA_INLINE void removeOutward(Vec& u, const FeltPlanes<balls>& shell, const Vec& x) {
  for (int pass = 0; pass < outwardPasses; ++pass)
    for (int i = 0; i < shell.count; ++i) {
      const Vec n = shell.normal(i);
      const Mask on = dot(x, n) > (1.0 - onShellWithin) * shell.offset(i);
      if (any(on)) removeOutward(u, n, on);
    }
}

/// Keeps one vertex inside of the planes, after the drift.
template <bool balls>
MORULA_INLINE void keepInPlanes(const FeltPlanes<balls>& shell, Vec& x, Vec& velocity, Vec& predicted) {
  Lanes excess = 0.0;
  for (int i = 0; i < shell.count; ++i) excess = max(excess, dot(x, shell.normal(i)) - shell.offset(i));
  const Mask outside = excess > Lanes(0.0);
  if (!any(outside)) return;
  Vec y = x;
  for (int pass = 0; pass < shellPasses; ++pass)
    for (int i = 0; i < shell.count; ++i) {
      const Vec n = shell.normal(i);
      y = y - max(dot(y, n) - shell.offset(i), Lanes(0.0)) * n;
    }
  Lanes reach = 1.0;
  for (int i = 0; i < shell.count; ++i) reach = max(reach, dot(y, shell.normal(i)) / shell.offset(i));
  y = (1.0 / reach) * y;
  Vec v = velocity, w = predicted;
  removeOutward(v, shell, y);
  removeOutward(w, shell, y);
  x = {select(outside, y.x, x.x), select(outside, y.y, x.y), select(outside, y.z, x.z)};
  velocity = {select(outside, v.x, velocity.x), select(outside, v.y, velocity.y), select(outside, v.z, velocity.z)};
  predicted = {select(outside, w.x, predicted.x), select(outside, w.y, predicted.y), select(outside, w.z, predicted.z)};
}

template <bool balls>
inline void keepAllInPlanes(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const FeltPlanes<balls> shell(b, p, lane);
    for (int v = 0; v < mesh.vertexCount; ++v) {
      Vec x = loadVec(b.position, v, lane), velocity = loadVec(b.velocity, v, lane),
          predicted = loadVec(b.predicted, v, lane);
      keepInPlanes(shell, x, velocity, predicted);
      storeVec(b.position, v, lane, x);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.predicted, v, lane, predicted);
    }
  }
}

/// Runs a drift without a shell, then keeps the vertices inside of the planes.
template <auto drift, bool balls = false>
inline void driftInPlanes(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  drift(mesh, b, p, dt);
  keepAllInPlanes<balls>(mesh, b, p);
}

/// Runs a kick without a shell; then the planes bear the forces against them.
template <auto kick, bool balls = false>
inline void kickInPlanes(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  kick(mesh, b, p, dt);
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const FeltPlanes<balls> shell(b, p, lane);
    for (int v = 0; v < mesh.vertexCount; ++v) {
      const Vec x = loadVec(b.position, v, lane);
      Vec velocity = loadVec(b.velocity, v, lane), acceleration = loadVec(b.acceleration, v, lane);
      removeOutward(velocity, shell, x);
      removeOutward(acceleration, shell, x);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.acceleration, v, lane, acceleration);
    }
  }
}

}  // namespace morula::MORULA_ISA
