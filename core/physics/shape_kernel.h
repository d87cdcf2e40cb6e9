#pragma once
// Shape matching [Müller, Heidelberger, Teschner, Gross 2005; Nilsson 2008, §3.2.2, eq. 3.4, 3.5]: each vertex is drawn
// to its place in the shape at rest, laid over the cell as well as it can be.
//
//   q_i                         vertex i of the shape at rest, from its centre; c the cell's centre, p_i = x_i − c
//   A = (Σ p qᵀ)(Σ q qᵀ)⁻¹      the linear map that takes the q closest to the p
//   R                           the rotation nearest to Σ p qᵀ
//   T = β A/∛det A + (1 − β) R  what the shape may become: with β its linear deformations too, at its volume
//   a_i = −k (p_i − T q_i) − κ (v_i − v_c − ω × p_i)
//
// with v_c + ω × p the rigid motion that has the cell's momentum and angular momentum. Forces sum to zero and
// to no torque, for any β: Σ q = 0, and both R (Σ p qᵀ)ᵀ and A (Σ p qᵀ)ᵀ are symmetric.
//
// A cell that is flat has det A = 0 and no A/∛det A. Below an eighth of its volume det A counts as that eighth.
#include "physics/rotation_kernel.h"

namespace morula::MORULA_ISA {

constexpr double minDeterminant = 0.125;

/// Cube root of numbers from minDeterminant to 10⁹, exact to rounding: a^(5/16) is off by 8 % to 54 %, and Newton's
/// iteration doubles the digits.
MORULA_INLINE Lanes cubeRootOf(Lanes a) {
  Lanes x = sqrt(sqrt(a * sqrt(sqrt(a))));
  for (int turn = 0; turn < 7; ++turn) x = x - (x - a / (x * x)) / 3.0;
  return x;
}

/// The motion of a cell as a whole, from sums over its vertices.
struct Match {
  Vec centre, drift, omega;  // c, v_c, ω
  Matrix map, goal;          // A, and T times the scale of the shape at rest
};

/// The spin of a needle thinner than about a millionth of its length, about its axis, cannot be determined.
constexpr double minInertia = single ? 1e-6 : 1e-12;  // determinant over trace³

/// Returns ω of the rigid motion: I ω = angular momentum, or 0 where I has no inverse.
MORULA_INLINE Vec findSpin(const Matrix& squares, const Vec& angular) {
  const Matrix inertia = inertiaOf(squares);
  const Lanes trace = inertia.x.x + inertia.y.y + inertia.z.z, none = 0.0;
  const Mask sound = determinant(inertia) > minInertia * (trace * trace * trace);
  const Vec omega = solve(inertia, angular);
  return {select(sound, omega.x, none), select(sound, omega.y, none), select(sound, omega.z, none)};
}

template <bool resisted>
MORULA_INLINE Match matchShape(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, int lane) {
  const Vec first = loadVec(b.position, 0, lane);
  Vec x = zeroVec(), w = zeroVec(), angular = zeroVec();
  Matrix products = zeroMatrix(), squares = zeroMatrix();
  for (int v = 0; v < mesh.vertexCount; ++v) {
    const Vec r = loadVec(b.position, v, lane) - first;
    const double* q = mesh.restShape + 3 * v;
    x += r;
    products = products + outer(r, Vec{Lanes(q[0]), Lanes(q[1]), Lanes(q[2])});
    if constexpr (resisted) {
      const Vec u = loadVec(b.predicted, v, lane);
      w += u, angular += cross(r, u), squares = squares + outer(r, r);
    }
  }
  const Lanes share = 1.0 / mesh.vertexCount, scale = load(b.restScale + lane), inverse = 1.0 / scale;
  Match m;
  const Vec middle = share * x;
  m.centre = first + middle;
  m.drift = share * w;
  if constexpr (resisted) m.omega = findSpin(squares - outer(middle, x), angular - cross(middle, w));
  const double* i = mesh.restInverse;
  const Matrix inverseSquares{{Lanes(i[0]), Lanes(i[1]), Lanes(i[2])},
                              {Lanes(i[1]), Lanes(i[3]), Lanes(i[4])},
                              {Lanes(i[2]), Lanes(i[4]), Lanes(i[5])}};  // symmetric: rows are columns
  m.map = inverse * Matrix{inverseSquares * products.x, inverseSquares * products.y, inverseSquares * products.z};
  const Matrix rotation = nearestRotation((inverse * Lanes(i[0])) * products);
  const Lanes linear = p.shapeLinear / cubeRootOf(max(determinant(m.map), Lanes(minDeterminant)));
  m.goal = (scale * linear) * m.map + (scale * Lanes(1 - p.shapeLinear)) * rotation;
  return m;
}

/// acceleration ← force, with drag's −drag·m·w. `measured`: volume ← volume of the shape at rest under A, for scenes in
/// which no ring pass finds the mesh's volume.
template <bool resisted, bool measured>
inline void findShapeForces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const Lanes stiffness = p.shapeStiffness, damping = p.shapeDamping, drag = p.drag;
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Match m = matchShape<resisted>(mesh, b, p, lane);
    const Lanes mass = load(b.vertexMass + lane);
    if constexpr (measured) {
      const Lanes scale = load(b.restScale + lane);
      store(b.volume + lane, mesh.restVolume * (scale * scale * scale) * determinant(m.map));
    }
    for (int v = 0; v < mesh.vertexCount; ++v) {
      const double* q = mesh.restShape + 3 * v;
      const Vec r = loadVec(b.position, v, lane) - m.centre;
      Vec a = stiffness * (m.goal * Vec{Lanes(q[0]), Lanes(q[1]), Lanes(q[2])} - r);
      if constexpr (resisted) {
        const Vec u = loadVec(b.predicted, v, lane);
        a -= damping * ((u - m.drift) - cross(m.omega, r)) + drag * u;
      }
      storeVec(b.acceleration, v, lane, mass * a);
    }
  }
}

}  // namespace morula::MORULA_ISA
