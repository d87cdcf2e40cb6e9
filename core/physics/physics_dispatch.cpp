#include "physics/physics_kernels.h"

namespace morula {

#define MORULA_DECLARE(isa)            \
  namespace isa {                      \
  extern const PhysicsKernels physics; \
  }
MORULA_DECLARE(scalar)
MORULA_DECLARE(narrow)
#if defined(MORULA_WITH_AVX)
MORULA_DECLARE(avx2)
MORULA_DECLARE(avx512)
static const PerIsa<PhysicsKernels> tables{&scalar::physics, &narrow::physics, &avx2::physics,
                                           &avx512::physics};
#else
static const PerIsa<PhysicsKernels> tables{&scalar::physics, &narrow::physics, nullptr, nullptr};
#endif

const PhysicsKernels& physicsKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
