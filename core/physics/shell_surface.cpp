#include "physics/shell_surface.h"

#include <algorithm>
#include <cmath>

namespace morula {

std::vector<Point> measureHeldPoints(const Mesh& surface, const ShellParameters& shell) {
  std::vector<Point> held = surface.vertices;
  if (shell.mesh || shell.holds == Held::vertices) return held;
  const double* a = shell.semiAxes;
  const auto slope = [a](const Vector& u) {
    return Vector{u.x / (a[0] * a[0]), u.y / (a[1] * a[1]), u.z / (a[2] * a[2])};
  };
  std::vector<double> depth(held.size()), neighbours(held.size());
  for (const Face& face : surface.faces)
    for (int k = 0; k < 3; ++k) {  // of the two faces at an edge one runs along it from each end
      const Vector d = surface.vertices[face[(k + 1) % 3]] - surface.vertices[face[k]];
      depth[face[k]] += dot(d, slope(d));
      neighbours[face[k]] += 1;
    }
  for (std::size_t v = 0; v < held.size(); ++v) {
    constexpr double near = 1 - 1e-6;  // the shell puts points onto itself to rounding, of single precision too
    const Point x = held[v];
    const Vector s = slope(x);
    const double reach = std::sqrt(dot(x, s));
    if (!(reach > near)) continue;
    const Vector sag = (0.125 * depth[v] / neighbours[v] / dot(s, s)) * s;
    double share = 1;  // of the sag that puts the point onto the shell
    for (int turn = 0; turn < 4; ++turn) {
      held[v] = x - share * sag;
      const double lowered = reach - std::sqrt(dot(held[v], slope(held[v])));
      share = std::clamp(share * (reach - 1) / lowered, 1 - heldWithin, 1 + heldWithin);
    }
    held[v] = x - share * sag;
  }
  return held;
}

}  // namespace morula
