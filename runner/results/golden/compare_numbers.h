#pragma once
// How a golden's numbers, and the rows and columns of recorded tables, are compared with a run's.
#include <map>
#include <string>
#include <vector>

#include "golden/difference.h"
#include "golden/golden.h"

namespace morula {

/// An item of the golden and the same item of the run; null if one of them does not have it.
struct ItemPair {
  const GoldenItem* golden = nullptr;
  const GoldenItem* observed = nullptr;
};

/// The pairs of one check, in the golden's order, then the items that only the run has.
using ItemPairs = std::vector<ItemPair>;

/// The result of a check with `items` items, among which these differences were found.
CheckResult resultOf(const std::string& check, std::vector<Difference> differences, std::size_t items);

/// Compares all numbers of `values` and of rows in `tables` by the rules that apply to them. Adds the results
/// `tolerances`, `completeness`, one for each rule, and `tables`: the columns, and what is not a number in rows.
void compareNumbers(const Golden& golden, const ItemPairs& values, const ItemPairs& tables,
                    std::vector<CheckResult>& results);

}  // namespace morula
