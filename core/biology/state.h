#pragma once
// A biological state is a set of substances. States are interned: equal sets have equal ids, so a cell stores
// 4 bytes, and a state's successor is computed once.
#include <cstdint>

namespace morula {

using SubstanceId = std::uint32_t;
using StateId = std::uint32_t;

}  // namespace morula
