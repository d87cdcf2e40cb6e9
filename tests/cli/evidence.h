#pragma once
// The numbers of a document, held against lines of results: every number that a paragraph states must be found there.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cli/document.h"
// Included last, because of CHECK:
#include "catch.h"

namespace morula::test {

/// True if the results' number, rounded as far as the document's, is the same.
inline bool rounds(const Number& result, const Number& said, double scale = 1) {
  if (scale == 1 && said.decimals > result.decimals) return false;
  const auto rounded = [&](double value) { return std::llround(value * std::pow(10, said.decimals)); };
  return rounded(scale * result.value) == rounded(said.value);
}

inline Number negative(Number number) {
  number.value = -number.value;
  return number;
}

/// A line of results: what was found of a claim, or a line that a command prints.
struct Evidence {
  explicit Evidence(std::string line, const std::string& claim = "")
      : found(std::move(line)), words(claim + '\n' + found + '\n'), numbers(numbersIn(found)) {}
  std::string found, words;
  std::vector<Number> numbers;  // of `found`

  /// Looks for the number as a mean or a difference of either sign; not as an end of an interval, a p-value or a share of
  /// the variance.
  bool has(const Number& said, double scale = 1) const {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::string before = found.substr(0, numbers[i].begin);
      const auto follows = [&](const char* end) { return before.ends_with(end); };
      const bool isOther = isInterval(i) || isInterval(i + 1) || (scale == 1 && follows("±")) || follows("p = ") ||
                           follows("p < ") || follows("η² ") || follows(" at most ");
      if (!isOther && (rounds(numbers[i], said, scale) || rounds(negative(numbers[i]), said, scale))) return true;
    }
    return false;
  }

  /// "low to high", or the same of the opposite difference.
  bool hasInterval(const Number& low, const Number& high) const {
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      const Number &first = numbers[i - 1], &second = numbers[i];
      if (isInterval(i) && ((rounds(first, low) && rounds(second, high)) ||
                            (rounds(negative(second), low) && rounds(negative(first), high))))
        return true;
    }
    return false;
  }

  bool says(const std::string& part) const { return words.find(part) != words.npos; }

 private:
  /// True if the number before this one and this one are "low to high".
  bool isInterval(std::size_t i) const {
    if (i == 0 || i >= numbers.size()) return false;
    const std::size_t end = numbers[i - 1].end;
    return found.substr(end, numbers[i].begin - end) == " to ";
  }
};

/// Radius of the worm's egg [µm], by which scenarios/worm/README.md converts lengths.
constexpr double eggRadius = 17.05;

/// Every number with a decimal point, every percentage, every "9 of 10" and every interval of a paragraph is in the
/// evidence; an interval in brackets in the same line as the number before it.
inline void checkNumbers(const std::string& text, const std::vector<Evidence>& evidence) {
  const auto numbers = numbersIn(text);
  const auto digits = [&](const Number& a) { return text.substr(a.begin, a.end - a.begin); };
  const auto between = [&](const Number& a, const Number& b) { return text.substr(a.end, b.begin - a.end); };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Number& number = numbers[i];
    const Number* next = i + 1 < numbers.size() ? &numbers[i + 1] : nullptr;
    const std::string before = text.substr(0, number.begin), after = text.substr(number.end, 4);
    const bool isShare = after.starts_with(" %");
    INFO(text.substr(number.begin, 30));
    const auto anyLine = [&](const auto& holds) { return std::ranges::any_of(evidence, holds); };
    if (before.ends_with("within ")) {
      CHECK(anyLine([&](const Evidence& line) {
        const std::string margin = "within " + digits(number) + (isShare ? "%" : "");
        return line.says(margin + ' ') || line.says(margin + '\n');
      }));
    } else if (before.ends_with("p = ")) {
      CHECK(anyLine([&](const Evidence& line) { return line.says("p = " + digits(number) + ' '); }));
    } else if (after.starts_with(" µm")) {
      CHECK(anyLine([&](const Evidence& line) { return line.has(number, eggRadius); }));
    } else if (next && between(number, *next) == " of ") {
      CHECK(anyLine([&](const Evidence& line) {
        return line.says(' ' + digits(number) + " of " + digits(*next) + ' ') ||
               (number.value == next->value && line.says("every one of " + digits(*next) + ' '));
      }));
      ++i;
    } else if (next && between(number, *next) == " to " && (number.decimals > 0 || next->decimals > 0)) {
      const Number* mean = i > 0 && between(numbers[i - 1], number) == " (" ? &numbers[i - 1] : nullptr;
      CHECK(
          anyLine([&](const Evidence& line) { return line.hasInterval(number, *next) && (!mean || line.has(*mean)); }));
      ++i;
    } else if (isShare) {
      CHECK(anyLine([&](const Evidence& line) { return line.says(' ' + digits(number) + " %"); }));
    } else if (number.decimals > 0) {
      CHECK(anyLine([&](const Evidence& line) { return line.has(number); }));
    }
  }
}

}  // namespace morula::test
