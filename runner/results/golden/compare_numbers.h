#pragma once
// Comparison of a golden's numbers, and of its rows and columns of recorded tables, with a run's.
#include <map>
#include <string>
#include <vector>

#include "golden/difference.h"
#include "golden/golden.h"

namespace morula {

/// An item of the golden and the same item of the run; null if golden or run lacks it.
struct ItemPair {
  const GoldenItem* golden = nullptr;
  const GoldenItem* observed = nullptr;
};

/// The pairs of one check, in the golden's order, then the items that only the run has.
using ItemPairs = std::vector<ItemPair>;

/// Returns the result of a check of `items` items with these differences.
CheckResult resultOf(const std::string& check, std::vector<Difference> differences, std::size_t items);

/// Compares all numbers of `values` and of rows in `tables` by the rules that apply to them. Adds the results
/// `tolerances`, `completeness`, one for each rule, and `tables`: columns, and values that are not numbers.
void compareNumbers(const Golden& golden, const ItemPairs& values, const ItemPairs& tables,
                    std::vector<CheckResult>& results);

}  // namespace morula
