#include "physics/physics_kernels.h"

namespace morula {

MORULA_TABLES(PhysicsKernels, physics, doubleTables, )
MORULA_TABLES(PhysicsKernels, physics, singleTables, _single)

const PhysicsKernels& physicsKernels(Isa isa, Precision precision) {
  return precision == Precision::binary64 ? doubleTables[isa] : singleTables[isa];
}

}  // namespace morula
