#pragma once
// Numbers as text and back: the shortest text that gives the
// same bits, in the C locale, and nothing but a number.
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace morula {

inline std::string writeReal(double value) {
  char text[32];  // the longest shortest form has 24 characters: -2.2250738585072014e-308
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

template <class Number>
std::optional<Number> readNumber(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

inline std::optional<double> readReal(std::string_view text) { return readNumber<double>(text); }
inline std::optional<std::uint64_t> readNatural(std::string_view text) {
  return readNumber<std::uint64_t>(text);
}

}  // namespace morula
