#pragma once
// Hashes out of texts: the way back from Hash::text.
#include <charconv>
#include <optional>
#include <string_view>

#include "base/hash.h"

namespace morula {

/// 32 hexadecimal digits, as Hash::text writes them.
inline std::optional<Hash> readHash(std::string_view text) {
  if (text.size() != 32 || text.find_first_not_of("0123456789abcdef") != text.npos) return std::nullopt;
  Hash hash;
  std::from_chars(text.data(), text.data() + 16, hash.high, 16);
  std::from_chars(text.data() + 16, text.data() + 32, hash.low, 16);
  return hash;
}

}  // namespace morula
