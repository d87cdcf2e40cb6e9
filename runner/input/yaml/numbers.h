#pragma once
// Numbers as people write them: no octal or hexadecimal, no units, no .inf, no trailing text. A text gives the same
// number on every machine and in every locale.
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "base/number_text.h"

namespace morula::scenario {

/// A number, or the mistake in its text as half a sentence: "has a leading zero".
template <class T>
struct Parsed {
  T value{};
  std::string wrong;  // empty: no mistake
};

/// Parses a finite number in decimal notation with '.', optional sign, optional exponent.
Parsed<double> parseReal(std::string_view text);
/// Parses decimal digits.
Parsed<std::uint64_t> parseNatural(std::string_view text);

/// [byte] Parses "500M", "8G", "1.5G", "200000000": k, M, G and T are powers of 1000.
Parsed<double> parseSize(std::string_view text);

/// An interval of numbers. Open ends exclude their value.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool openLow = false;
  bool ordinary = false;  // and nothing that is smaller or larger than ordinary numbers

  bool holds(double value) const { return (openLow ? value > low : value >= low) && value <= high; }
  /// Returns "> 0", "≥ 0", "from 0 to 4"; "" if everything is allowed.
  std::string text() const;
};

inline constexpr Range positive{.low = 0, .openLow = true, .ordinary = true};
inline constexpr Range notNegative{.low = 0, .ordinary = true};
/// The range of ordinary numbers other than 0: their cubes, and products of a few of them, do not overflow.
inline constexpr Range ordinaryNumbers{.low = 1e-30, .high = 1e30};

}  // namespace morula::scenario
