#pragma once
// Reads numbers from texts in the C locale that hold nothing but a number. The inverse, the shortest text that gives
// the same bits, is exactText.
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/number_text.h"

namespace morula {

template <class Number>
std::optional<Number> readNumber(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

inline std::optional<double> readReal(std::string_view text) { return readNumber<double>(text); }
inline std::optional<std::uint64_t> readNatural(std::string_view text) { return readNumber<std::uint64_t>(text); }

}  // namespace morula
