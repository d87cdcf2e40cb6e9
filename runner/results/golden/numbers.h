#pragma once
// The numbers in a golden's items to which tolerance rules apply.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct GoldenNumber {
  std::string name;  // what rules match: "final/AB/volume", "contact/0.25/A/B/area"
  std::uint64_t step = 0;
  double value = 0;  // 0 where it was not measured
};

/// The number of a line `value`, and those of a line `row`.
std::vector<GoldenNumber> numbersIn(const GoldenItem& item);
/// Returns the numbers of all items.
std::vector<GoldenNumber> numbersIn(const GoldenData& data);

/// The last rule that matches; null if none does.
const ToleranceRule* ruleFor(const std::vector<ToleranceRule>& rules, const GoldenNumber& number);

/// One word of a row: the column's name and its value as the file has it, "-" where it is NULL.
struct RowValue {
  std::string column, text;
};
std::vector<RowValue> valuesOf(const GoldenRow& row);

/// "contact" of "contact/area" and of "contact/0.25/A/B".
std::string tableOf(const std::string& name);

}  // namespace morula
