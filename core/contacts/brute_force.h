#pragma once
// All vertices against all of other cells: the oracle. It shares no code with the other ways to search, and
// stores nothing between searches.
#include "contacts/search.h"

namespace morula {

struct BruteForce {};

inline void prepare(BruteForce&, const SearchInput&) {}
void searchBlock(const BruteForce&, const SearchInput& input, int block, BlockLists& lists);

}  // namespace morula
