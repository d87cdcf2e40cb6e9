#pragma once
// 3 × 3 matrices, one per lane, as rows.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct Matrix {
  Vec x, y, z;

  friend MORULA_INLINE Vec operator*(const Matrix& m, const Vec& v) { return {dot(m.x, v), dot(m.y, v), dot(m.z, v)}; }
  friend MORULA_INLINE Matrix operator*(Lanes s, const Matrix& m) { return {s * m.x, s * m.y, s * m.z}; }
  friend MORULA_INLINE Matrix operator+(const Matrix& a, const Matrix& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend MORULA_INLINE Matrix operator-(const Matrix& a, const Matrix& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

MORULA_INLINE Vec zeroVec() { return {Lanes(0.0), Lanes(0.0), Lanes(0.0)}; }
MORULA_INLINE Matrix zeroMatrix() { return {zeroVec(), zeroVec(), zeroVec()}; }

/// a bᵀ
MORULA_INLINE Matrix outer(const Vec& a, const Vec& b) { return {a.x * b, a.y * b, a.z * b}; }

MORULA_INLINE Lanes determinant(const Matrix& m) { return dot(m.x, cross(m.y, m.z)); }

/// tr(M) − M: for M = Σ r sᵀ the matrix of ω ↦ Σ s × (ω × r).
MORULA_INLINE Matrix inertiaOf(const Matrix& m) {
  const Lanes trace = m.x.x + m.y.y + m.z.z;
  return {{trace - m.x.x, -m.x.y, -m.x.z}, {-m.y.x, trace - m.y.y, -m.y.z}, {-m.z.x, -m.z.y, trace - m.z.z}};
}

/// Returns the solution v of M v = a, by Cramer's rule; not finite where M has no inverse.
MORULA_INLINE Vec solve(const Matrix& m, const Vec& a) {
  const Vec first = cross(m.y, m.z), second = cross(m.z, m.x), third = cross(m.x, m.y);
  return (1.0 / dot(m.x, first)) * (a.x * first + a.y * second + a.z * third);
}

}  // namespace morula::MORULA_ISA
