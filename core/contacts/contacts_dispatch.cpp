#include "contacts/contacts_kernels.h"

namespace morula {

#define MORULA_DECLARE(isa)             \
  namespace isa {                       \
  extern const ContactKernels contacts; \
  }
MORULA_DECLARE(scalar)
MORULA_DECLARE(narrow)
#if defined(MORULA_WITH_AVX)
MORULA_DECLARE(avx2)
MORULA_DECLARE(avx512)
static const PerIsa<ContactKernels> tables{&scalar::contacts, &narrow::contacts, &avx2::contacts,
                                           &avx512::contacts};
#else
static const PerIsa<ContactKernels> tables{&scalar::contacts, &narrow::contacts, nullptr, nullptr};
#endif

const ContactKernels& contactKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
