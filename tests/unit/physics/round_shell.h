#pragma once
// Closed forms for shells that are spheres or ellipsoids.
#include "lab.h"

namespace morula {

/// Returns spheres and ellipsoids, small and large.
inline std::vector<ShellParameters> roundShells(Held holds) {
  return {{{1, 1, 1}, {}, holds}, {{2.5, 2.5, 2.5}, {}, holds}, {{1.25, 1, 0.8}, {}, holds}, {{27, 15, 11}, {}, holds}};
}

inline PhysicsParameters inShell(const ShellParameters& shell) {
  PhysicsParameters p = softCell();
  p.shell = shell;
  return p;
}

/// Returns the shell that the first cell's vertices feel: for held surfaces, half-axes are longer by their sag.
inline ShellParameters felt(const Bodies& b) {
  ShellParameters shell = *b.parameters.shell;
  for (double& a : shell.semiAxes) a += shell.holds == Held::surface ? b.sag[0] : 0;
  return shell;
}

/// Returns 1 for a point on the shell, less for a point inside.
inline double quadric(const Point& x, const ShellParameters& shell) {
  const double* a = shell.semiAxes.data();
  const Vector q{x.x / a[0], x.y / a[1], x.z / a[2]};
  return std::sqrt(dot(q, q));
}

inline Vector outward(const Point& x, const ShellParameters& shell) {
  const double* a = shell.semiAxes.data();
  const Vector g{x.x / (a[0] * a[0]), x.y / (a[1] * a[1]), x.z / (a[2] * a[2])};
  return g / norm(g);
}

/// Returns the nearest point of the ellipsoid to a point outside: x_i = p_i a_i²/(a_i² + t) with the t that puts x on
/// the ellipsoid, by bisection [Eberly 2013].
inline Point nearestOnShell(const Point& p, const ShellParameters& shell) {
  const double* a = shell.semiAxes.data();
  const auto at = [&](double t) {
    return Point{p.x * a[0] * a[0] / (a[0] * a[0] + t), p.y * a[1] * a[1] / (a[1] * a[1] + t),
                 p.z * a[2] * a[2] / (a[2] * a[2] + t)};
  };
  double low = 0, high = 1e6;
  for (int i = 0; i < 200; ++i) (quadric(at((low + high) / 2), shell) > 1 ? low : high) = (low + high) / 2;
  return at(high);
}

}  // namespace morula
