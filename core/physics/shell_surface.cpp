#include "physics/shell_surface.h"

namespace morula {

Point heldPoint(const Point& x, const ShellParameters& shell, double sag) {
  if (shell.mesh || shell.holds == Held::vertices) return x;
  const double* a = shell.semiAxes;
  return {x.x * (a[0] / (a[0] + sag)), x.y * (a[1] / (a[1] + sag)), x.z * (a[2] / (a[2] + sag))};
}

}  // namespace morula
