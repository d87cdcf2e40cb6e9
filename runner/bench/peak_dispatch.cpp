#include "bench/peak_kernels.h"

namespace morula {

#define MORULA_DECLARE(isa)      \
  namespace isa {                \
  extern const PeakKernels peak; \
  }
MORULA_DECLARE(scalar)
MORULA_DECLARE(narrow)
#if defined(MORULA_WITH_AVX)
MORULA_DECLARE(avx2)
MORULA_DECLARE(avx512)
static const PerIsa<PeakKernels> tables{&scalar::peak, &narrow::peak, &avx2::peak, &avx512::peak};
#else
static const PerIsa<PeakKernels> tables{&scalar::peak, &narrow::peak, nullptr, nullptr};
#endif

const PeakKernels& peakKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
