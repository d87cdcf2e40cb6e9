#pragma once
// Lists, as found, become slices: eight vertices side by side, as the kernels of the contact laws read them.
#include "contacts/neighbour_list.h"

namespace morula {

/// All that were found, or those that may act.
RowLists& foundLists(BlockLists& lists);
RowLists& actingLists(BlockLists& lists);

/// Fills slices, firstSlice and indices from one kind of each block's lists.
void cutIntoSlices(NeighbourList& list, RowLists& (*listsOf)(BlockLists&), const Bodies& bodies, int threads);

}  // namespace morula
