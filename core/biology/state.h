#pragma once
// A biological state is a set of substances. States are interned: equal sets have equal ids, so a cell carries
// 4 bytes, and what a state leads to is worked out once.
#include <cstdint>

namespace morula {

using SubstanceId = std::uint32_t;
using StateId = std::uint32_t;

}  // namespace morula
