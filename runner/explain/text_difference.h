#pragma once
// Two texts, line by line.
#include <string>

namespace morula {

/// Lines that only one of the two has, in order: "  - theirs", "  + ours"; at most forty. "" if they are
/// equal.
std::string differingLines(const std::string& theirs, const std::string& ours);

}  // namespace morula
