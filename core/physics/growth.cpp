#include "physics/growth.h"

#include <algorithm>

#include "base/maths.h"
#include "physics/cell_model.h"

namespace morula {

void grow(Bodies& b, int slot, double rate, double timeStep) {
  const double change = rate * timeStep;
  b.pressureConstant[slot] *= 1 + change;
  b.vertexMass[slot] *= 1 + change;
  b.restScale[slot] *= 1 + change / 3;
}

double sizeAtRest(const Bodies& b, int slot) {
  const double ofEgg = b.parameters.pressure.constant, scale = b.restScale[slot];
  if (b.model().hasMembrane && ofEgg > 0) return b.pressureConstant[slot] / ofEgg;
  return scale * scale * scale;
}

void growUntil(Bodies& b, int slot, double rate, double timeStep, double size) {
  const double missing = size / sizeAtRest(b, slot);
  if (!(missing > 1)) return;
  const bool byFluid = b.model().hasMembrane && b.parameters.pressure.constant > 0;
  // The relative change of k_p, or three times that of lengths.
  const double most = byFluid ? missing - 1 : 3 * (cubeRoot(missing) - 1);
  grow(b, slot, std::min(rate * timeStep, most), 1);
}

}  // namespace morula
