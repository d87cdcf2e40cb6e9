#include "contacts/search_kernels.h"

namespace morula {

#define MORULA_DECLARE(isa)          \
  namespace isa {                    \
  extern const SearchKernels search; \
  }
MORULA_DECLARE(scalar)
MORULA_DECLARE(narrow)
#if defined(MORULA_WITH_AVX)
MORULA_DECLARE(avx2)
MORULA_DECLARE(avx512)
static const PerIsa<SearchKernels> tables{&scalar::search, &narrow::search, &avx2::search, &avx512::search};
#else
static const PerIsa<SearchKernels> tables{&scalar::search, &narrow::search, nullptr, nullptr};
#endif

const SearchKernels& searchKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
