#include "physics/sag.h"

#include <algorithm>

#include "base/maths.h"
#include "physics/shell_surface.h"

namespace morula {

double measureFreeScale(const Bodies& b, int slot) {
  if (!b.model().hasMembrane) return 1;
  const MeshTemplate& mesh = b.meshOf(slot);
  const double scale = b.restScale[slot], contents = b.pressureConstant[slot];
  if (!(contents > 0)) return 1;
  const double outside = b.parameters.pressure.outside * mesh.volume * scale * scale * scale;
  const double springs = b.parameters.membrane.stiffness * mesh.restSquares * scale * scale / 3;
  double least = 0.5, most = 2;  // the left side minus the right side of the equation in sag.h falls with s
  for (int i = 0; i < 50; ++i) {
    const double s = 0.5 * (least + most);
    (contents > s * (outside * s * s + springs * (s - 1)) ? least : most) = s;
  }
  return 0.5 * (least + most);
}

void setSags(Bodies& b) {
  std::ranges::fill(b.sag, 0);
  if (b.areSpheres()) return;
  double free = 0;  // [length³] free volume of all cells
  for (int slot : b.slots) {
    const double scale = b.restScale[slot] * measureFreeScale(b, slot);
    b.sag[slot] = b.meshOf(slot).sag * scale;
    free += b.meshOf(slot).volume * scale * scale * scale;
  }
  if (!b.parameters.shell) return;
  const double room = measureShellVolume(*b.parameters.shell);
  if (free <= room) return;
  const double share = cubeRoot(room / free);
  for (int slot : b.slots) b.sag[slot] *= share;
}

}  // namespace morula
