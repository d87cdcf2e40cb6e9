#include "division/tilt.h"

#include <algorithm>

#include "base/maths.h"

namespace morula {
namespace {

constexpr double pi = 3.141592653589793;

struct Tangents {
  Vector s, t;
};

/// Returns two unit vectors at right angles to a unit vector n and to each other; the sign of n.z makes the only two
/// cases [Duff et al. 2017].
Tangents tangentsOf(const Vector& n) {
  const double sign = n.z < 0 ? -1 : 1;
  const double a = -1 / (sign + n.z), b = n.x * n.y * a;
  return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace

Vector tiltAxis(const Vector& axis, double degrees, const Draw& draw) {
  const double sd = degrees * (pi / 180), kappa = 1 / (sd * sd);
  const double u = 1 - randomUnit(draw, 0);  // (0, 1]: its logarithm is finite
  const auto [sine, cosine] = sineAndCosine(2 * pi * randomUnit(draw, 1));
  // 1 − w keeps its digits where w is almost 1.
  const double drop = std::min(-naturalLog(u + (1 - u) * exponential(-2 * kappa)) / kappa, 2.0);
  const double across = std::sqrt(drop * (2 - drop));
  const auto [s, t] = tangentsOf(axis);
  const Vector tilted = (1 - drop) * axis + across * (cosine * s + sine * t);
  return tilted / norm(tilted);
}

}  // namespace morula
