#pragma once
// Lists, as found, become slices: eight vertices side by side, as the kernels of the contact laws read them.
#include "contacts/neighbour_list.h"

namespace morula {

/// Fills slices, firstSlice and indices from perBlock.
void cutIntoSlices(NeighbourList& list, const Bodies& bodies, int threads);

}  // namespace morula
