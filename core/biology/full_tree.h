#pragma once
// DNA for a complete binary lineage tree [Nilsson 2008, §5.2.3]: no two cells alike, nothing simplified.
#include <string>

namespace morula {

/// Returns DNA text in which every cell divides `levels` times (1 to 16) and all 2^levels final cells are unique; 10
/// levels are the thesis' tree of C. elegans: 1024 leaves, 1023 + 1023 + 1024 + 1024 = 4094 genes. The egg divides in
/// its first cycle, the final cells reach their final states in cycle levels + 1.
///
/// Substances bear the worm's names, so that a prefix names a subtree: P0 the egg; AB, its daughter A; P1,
/// its daughter B; EMS and P2 (the thesis' P'), P1's daughters A and B; after these one letter per division,
/// a or b: ABa, ABab, EMSb … Throws InputError if `levels` is out of range.
std::string makeFullTreeDna(int levels);

}  // namespace morula
