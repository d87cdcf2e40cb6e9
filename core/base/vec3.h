#pragma once
// A point or vector in space. Real is double (one cell) or Lanes (several cells side by side).
#include <cmath>

#include "base/members.h"

namespace morula {

template <class Real>
struct Vec3 {
  Real x{}, y{}, z{};

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(const Vec3& a, const Real& s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(const Real& s, const Vec3& a) { return a * s; }
  friend constexpr Vec3 operator/(const Vec3& a, const Real& s) { return {a.x / s, a.y / s, a.z / s}; }
  constexpr Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  constexpr Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  constexpr Vec3& operator*=(const Real& s) { return *this = *this * s; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

template <class Real>
constexpr Real dot(const Vec3<Real>& a, const Vec3<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Real>
constexpr Vec3<Real> cross(const Vec3<Real>& a, const Vec3<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double norm(const Vec3<double>& a) { return std::sqrt(dot(a, a)); }

using Point = Vec3<double>;
using Vector = Vec3<double>;
MORULA_MEMBERS(Vector, x, y, z)

}  // namespace morula
