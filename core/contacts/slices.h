#pragma once
// Lists, as found, become slices: eight vertices side by side, as the kernels of the contact laws read them.
#include <span>

#include "contacts/neighbour_list.h"

namespace morula {

/// Slices of one block from one kind of its lists. `far`: the number of the far row.
void cutIntoSlices(BlockLists& block, const RowLists& lists, VertexNumber firstOfBlock, VertexNumber far);

/// Cuts the lists of all blocks into slices, with all pairs that were found.
void cutIntoSlices(NeighbourList& list, const Bodies& bodies, int threads);

/// Writes the lists of these rows anew: where a vertex stands, or, if its slice is too short, in slices behind the
/// others.
void replaceInSlices(BlockLists& block, const RowLists& lists, std::span<const std::int32_t> rows,
                     VertexNumber firstOfBlock, VertexNumber far);

}  // namespace morula
