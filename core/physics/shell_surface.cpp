#include "physics/shell_surface.h"

#include <numbers>

#include "mesh/mesh_measures.h"

namespace morula {

Point heldPoint(const Point& x, const ShellParameters& shell, double sag) {
  if (shell.mesh || shell.holds == Held::vertices) return x;
  const double* a = shell.semiAxes.data();
  return {x.x * (a[0] / (a[0] + sag)), x.y * (a[1] / (a[1] + sag)), x.z * (a[2] / (a[2] + sag))};
}

double measureShellVolume(const ShellParameters& shell) {
  if (shell.mesh) return measureVolume(shell.mesh->mesh.vertices, shell.mesh->mesh.faces);
  return 4 * std::numbers::pi / 3 * shell.semiAxes[0] * shell.semiAxes[1] * shell.semiAxes[2];
}

}  // namespace morula
