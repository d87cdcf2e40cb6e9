#pragma once
// Numbers as text for messages: the same in every locale, and small numbers do not become 0.000000.
#include <charconv>
#include <string>

namespace morula {

/// Writes a number with `digits` significant digits, without trailing zeros.
inline std::string numberText(double a, int digits = 4) {
  char text[64];
  const auto result = std::to_chars(text, text + sizeof text, a, std::chars_format::general, digits);
  return {text, result.ptr};
}

/// The shortest text that reads back as this very number.
inline std::string exactText(double a) {
  char text[64];
  const auto result = std::to_chars(text, text + sizeof text, a);
  return {text, result.ptr};
}

}  // namespace morula
