// Compiled once per instruction set (core/CMakeLists.txt); see search_dispatch.cpp for the choice.
#include "contacts/search_kernels.h"

#include "contacts/near_kernel.h"
#include "contacts/sort_kernel.h"

namespace morula::MORULA_ISA {

extern const SearchKernels search;
const SearchKernels search = {.findNear = findNear, .sortShortList = sortShortList};

}  // namespace morula::MORULA_ISA
