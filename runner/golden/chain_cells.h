#pragma once
// Which cells differ where a chain of hashes does: the golden keeps four digits of each cell's hash.
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

/// Paths ("" is the egg) of the cells whose digits differ in two `step_hash` items of one step. Empty if
/// none differs, or where other cells live than the golden's lineage says.
std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenItem& expected,
                                         const GoldenItem& actual);

/// "the egg", "A, BA and 7 more".
std::string inWords(const std::vector<std::string>& cells);

}  // namespace morula
