#pragma once
// The tolerances of values in a golden, and their reasons.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace morula {

struct Tolerance {
  enum class Kind {
    exact,     // the same bits; −0 and 0 differ
    absolute,  // |a − e| ≤ amount
    relative,  // |a − e| ≤ amount · max(|e|, scale)
    ulp,       // at most `amount` representable numbers apart
  };
  Kind kind = Kind::exact;
  double amount = 0;
  double scale = 0;  // relative only: smaller values count as this large

  /// Returns the tolerance as in a golden: "exact", "abs 1e-9", "rel 1e-9 scale 1", "ulp 4".
  std::string text() const;
  /// Returns the max distance of a value from `expected`.
  double allowed(double expected) const;
  /// Returns the tolerance as a relative difference, for chaos horizons. An ulp counts as 2.2e-16.
  double size() const;
  /// Returns the used part of the tolerance: 0 for equal bits, 1 at its edge, infinite if nothing is allowed (exact, or
  /// NaN).
  double share(double expected, double actual) const;
  bool passes(double expected, double actual) const { return share(expected, actual) <= 1; }
};

/// A rule `tolerance PATTERN exact|abs X|rel X [scale X]|ulp N [until_step N] [why "…"]`. The last rule that matches a
/// value applies to it; a value that no rule matches must be exact.
struct ToleranceRule {
  std::string pattern;  // pattern of value names; * stands for any text
  Tolerance tolerance;
  std::optional<std::uint64_t> untilStep;  // matches values up to this step only
  std::string why;                         // required unless exact
  int line = 0;

  bool matches(std::string_view name, std::uint64_t step) const;
  std::string text() const;  // the rule as in the file
};

/// Reads one rule. Throws InputError that begins with `place`.
ToleranceRule readRule(std::string_view line, const std::string& place);

/// Returns the number of representable numbers from a to b: 0 if they are equal, as −0 and 0 are; the largest number if
/// one is NaN.
std::uint64_t ulpsBetween(double a, double b);

/// Returns true if the pattern, in which * stands for any text, matches the whole name.
bool fitsGlob(std::string_view pattern, std::string_view name);

}  // namespace morula
