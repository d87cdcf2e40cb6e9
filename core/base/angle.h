#pragma once
// Functions of angles, made of + − × ÷ and square roots only [base/maths.h].
#include <numbers>

#include "base/maths.h"
#include "base/vec3.h"

namespace morula {

/// arctan t in radians, for 0 ≤ t ≤ 1, to within 6e-16: arctan t = 2 arctan(t / (1 + √(1 + t²))), three times, and
/// then t − t³/3 + t⁵/5 − … with t ≤ 0.0985, where eight terms are exact to 1e-18.
inline double arcTangent(double t) {
  for (int i = 0; i < 3; ++i) t = t / (1 + std::sqrt(1 + t * t));
  double series = 0;
  for (int k = 15; k >= 1; k -= 2) series = 1.0 / k - t * t * series;
  return 8 * t * series;
}

/// Returns the angle [degree] between two lines through unit vectors, 0 to 90: 2 arctan(|u − v| / |u + v|). The formula
/// is exact for nearly parallel lines, too [Kahan 2006].
inline double angleOfLines(const Vector& u, const Vector& v) {
  constexpr double degree = 57.29577951308232;
  const double apart = norm(u - v), together = norm(u + v);
  const double t = apart < together ? apart / together : together / apart;
  return 2 * degree * arcTangent(t);
}

/// Returns x turned about the axis u of `turn` by φ, its length in degrees, counter-clockwise seen against u [Rodrigues
/// 1840]: cos φ x + sin φ u × x + (1 − cos φ) (u·x) u. If `turn` is zero, returns x itself.
inline Vector turnedBy(const Vector& turn, const Vector& x) {
  const double degrees = norm(turn);
  if (degrees == 0) return x;
  const Vector u = (1 / degrees) * turn;
  const auto [sine, cosine] = sineAndCosine(degrees * (std::numbers::pi / 180));
  return cosine * x + sine * cross(u, x) + ((1 - cosine) * dot(u, x)) * u;
}

}  // namespace morula
