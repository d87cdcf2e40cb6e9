#pragma once
// Cuts lists into slices: eight vertices side by side, as the kernels of the contact laws read them.
#include <span>

#include "contacts/neighbour_list.h"

namespace morula {

/// Cuts one block's lists of one kind into slices. `far`: the number of the far row.
void cutIntoSlices(BlockLists& block, const RowLists& lists, VertexNumber firstOfBlock, VertexNumber far);

/// Cuts the lists of all blocks into slices, with all pairs that were found.
void cutIntoSlices(NeighbourList& list, const Bodies& bodies, int threads);

/// Writes the lists of these rows anew: in place, or in slices behind the others where a row's slice is too short.
void replaceInSlices(BlockLists& block, const RowLists& lists, std::span<const std::int32_t> rows,
                     VertexNumber firstOfBlock, VertexNumber far);

}  // namespace morula
