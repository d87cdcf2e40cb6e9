#include "yaml/numbers.h"

#include <charconv>
#include <cmath>

namespace morula::scenario {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

std::size_t digitsAt(std::string_view text, std::size_t from) {
  std::size_t count = 0;
  while (from + count < text.size() && isDigit(text[from + count])) ++count;
  return count;
}

/// Returns the length of the decimal number that the text begins with, sign included; 0 if there is none.
std::size_t numberLength(std::string_view text) {
  std::size_t at = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const auto whole = digitsAt(text, at);
  at += whole;
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    fraction = digitsAt(text, at + 1);
    if (whole + fraction > 0) at += 1 + fraction;
  }
  if (whole + fraction == 0) return 0;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const auto sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+') ? 1u : 0u;
    if (const auto exponent = digitsAt(text, at + 1 + sign)) at += 1 + sign + exponent;
  }
  return at;
}

/// Returns the mistake in a text that should be one decimal number; "" if there is none.
std::string whatIsWrong(std::string_view text) {
  const auto length = numberLength(text);
  if (length == 0) {
    auto word = text.substr(!text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0);
    if (word == ".inf" || word == ".Inf" || word == ".INF" || word == "inf" || word == "infinity" || word == ".nan" ||
        word == ".NaN" || word == ".NAN" || word == "nan" || word == "NaN")
      return "is not a finite number";
    return "is not a number";
  }
  const auto digits = text.substr(isDigit(text[0]) || text[0] == '.' ? 0 : 1);
  if (digits.size() > 1 && digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'o' || digits[1] == 'b'))
    return "is not a decimal number";
  if (digits.size() > 1 && digits[0] == '0' && isDigit(digits[1])) return "has a leading zero, which could mean octal";
  if (length == text.size()) return "";
  auto rest = text.substr(length);
  if (rest[0] == ',') return "has a comma: decimals follow a point";
  while (!rest.empty() && rest[0] == ' ') rest.remove_prefix(1);
  return "has trailing text '" + std::string(rest) + "'";
}

}  // namespace

Parsed<double> parseReal(std::string_view text) {
  if (auto wrong = whatIsWrong(text); !wrong.empty()) return {0, wrong};
  if (text[0] == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return {0, "is too large or too small for a number"};
  if (error != std::errc() || end != text.data() + text.size()) return {0, "is not a number"};
  return {value == 0 ? 0.0 : value, ""};  // −0 is 0 to people
}

Parsed<std::uint64_t> parseNatural(std::string_view text) {
  if (auto wrong = whatIsWrong(text); !wrong.empty()) return {0, wrong};
  if (text[0] == '-') return {0, "is negative"};
  if (text[0] == '+') text.remove_prefix(1);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return {0, "is too large"};
  if (error != std::errc() || end != text.data() + text.size()) return {0, "is not a whole number"};
  return {value, ""};
}

Parsed<double> parseSize(std::string_view text) {
  const auto units = std::string_view("kMGT");
  const auto unit = text.empty() ? units.npos : units.find(text.back() == 'K' ? 'k' : text.back());
  if (unit == units.npos) return parseReal(text);
  auto size = parseReal(text.substr(0, text.size() - 1));
  for (std::size_t i = 0; i <= unit; ++i) size.value *= 1000;
  return size;
}

std::string Range::text() const {
  if (std::isfinite(low) && std::isfinite(high) && openLow) return "> " + exactText(low) + " and ≤ " + exactText(high);
  if (std::isfinite(low) && std::isfinite(high)) return "from " + exactText(low) + " to " + exactText(high);
  if (std::isfinite(low)) return (openLow ? "> " : "≥ ") + exactText(low);
  return "";
}

}  // namespace morula::scenario
