#pragma once
// One place where a run departs from its golden, in numbers and in words.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct Difference {
  std::string place;                  // "file:line", or the file alone for what the golden does not have
  std::optional<std::uint64_t> step;  // where the run and the golden part
  std::optional<std::string> cell;    // path; "" is the egg
  std::string field;
  std::string expected, actual;  // "" when the golden or the run has no such item
  std::string text;              // for people, one line
};

/// Compares an item that must be equal; both are of one kind and key, or one of them is null. Nothing if equal.
std::optional<Difference> findDifference(const std::string& file, const GoldenItem* golden, const GoldenItem* observed);

/// Two numbers in words: "expected 0.5 (0x3fe0000000000000), actual …, 1 ulp apart, actual − expected = …".
std::string compareInWords(double expected, double actual);

/// The differences that begin earliest come first; equal ones stay in the order of the file.
void sortByStep(std::vector<Difference>& differences);

/// At most nine lines, then how many more there are.
std::string listed(const std::vector<Difference>& differences);

/// Paths ("" is the egg) of the cells whose digits differ in two links of one step. Empty if
/// none differs, or where other cells live than the golden's lineage says.
std::vector<std::string> cellsThatDiffer(const GoldenData& golden, const GoldenLink& expected,
                                         const GoldenLink& actual);

/// "the egg", "A, BA and 7 more".
std::string inWords(const std::vector<std::string>& cells);

}  // namespace morula
