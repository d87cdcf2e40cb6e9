#include "physics/growth.h"

namespace morula {

void grow(Bodies& b, int slot, double rate, double timeStep) {
  const double change = rate * timeStep;
  b.pressureConstant[slot] *= 1 + change;
  b.vertexMass[slot] *= 1 + change;
  b.restScale[slot] *= 1 + change / 3;
}

}  // namespace morula
