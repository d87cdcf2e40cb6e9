#include "contacts/search_kernels.h"

namespace morula {

MORULA_TABLES(SearchKernels, search, tables, )

const SearchKernels& searchKernels(Isa isa) { return tables[isa]; }

}  // namespace morula
