#pragma once
// A difference of a run from its golden, in numbers and in words.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct Difference {
  std::string place;                  // "file:line", or the file alone for an item that the golden lacks
  std::optional<std::uint64_t> step;  // the step at which run and golden part
  std::optional<std::string> cell;    // path; "" is the egg
  std::string field;
  std::string expected, actual;  // "" when the golden or the run has no such item
  std::string text;              // for people, one line
};

/// Compares an item that must be equal; one of the two may be null. Returns nothing if they are equal.
std::optional<Difference> findDifference(const std::string& file, const GoldenItem* golden, const GoldenItem* observed);

/// Returns two numbers in words: "expected 0.5 (0x3fe0000000000000), actual …, 1 ulp apart, difference …".
std::string compareInWords(double expected, double actual);

/// Sorts differences by their first step; equal ones stay in the order of the file.
void sortByStep(std::vector<Difference>& differences);

/// Returns at most nine lines of differences, then the number of the others.
std::string listed(const std::vector<Difference>& differences);

/// Returns the paths ("" is the egg) of cells whose digits differ in two links of one step. Empty if none differs, or
/// if other cells live than the golden's lineage says.
std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenLink& expected,
                                         const GoldenLink& actual);

/// Returns cells in words: "the egg", "A, BA and 7 more".
std::string inWords(const std::vector<std::string>& cells);

}  // namespace morula
