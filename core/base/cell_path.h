#pragma once
// A cell's identity: the divisions that lead to it from the egg, one letter each, '' for the egg itself.
// Paths never change and never depend on the order of events, so they key random numbers and sort cells.
#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

namespace morula {

class CellPath {
 public:
  static constexpr int maxDepth = 120;  // divisions on one line of descent

  constexpr CellPath() = default;

  /// Reads "ABBA". Throws InputError on other letters or more than maxDepth of them.
  static CellPath parse(std::string_view text);

  /// The daughter that receives asymmetry substance A (b = false) or B (b = true).
  CellPath daughter(bool b) const;
  /// Returns the mother. Throws BugError for the egg, which has none.
  CellPath mother() const;

  constexpr int depth() const { return depth_; }
  constexpr bool isEgg() const { return depth_ == 0; }
  /// Letter number i, counted from the egg: false A, true B.
  constexpr bool letter(int i) const { return (i < 64 ? high_ >> (63 - i) : low_ >> (127 - i)) & 1; }
  /// True if `other` is this cell or descends from it.
  bool isAncestorOf(const CellPath& other) const;
  std::string text() const;

  constexpr std::uint64_t high() const { return high_; }  // letters 0..63, the first in the top bit
  constexpr std::uint64_t low() const { return low_; }    // letters 64..119

  // Lexicographic: a mother stands before her daughters, A before B, so a subtree is one contiguous range.
  friend constexpr auto operator<=>(const CellPath&, const CellPath&) = default;

 private:
  std::uint64_t high_ = 0, low_ = 0;
  std::int32_t depth_ = 0;
};

/// Returns the words for a cell with this path: "the egg", or "cell AB". Data for programs keep the bare path.
std::string cellName(std::string_view path);

}  // namespace morula
