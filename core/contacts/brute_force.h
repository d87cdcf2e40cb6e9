#pragma once
// Tests all vertices against all vertices of other cells. This oracle shares no code with the other searches, and
// stores nothing between searches.
#include "contacts/search.h"

namespace morula {

struct BruteForce {};

inline void prepare(BruteForce&, const SearchInput&) {}
void searchBlock(const BruteForce&, const SearchInput& input, int block, BlockLists& lists);

}  // namespace morula
