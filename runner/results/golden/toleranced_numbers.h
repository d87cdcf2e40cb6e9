#pragma once
// The numbers in a golden's items to which tolerance rules apply.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/golden.h"

namespace morula {

struct GoldenNumber {
  std::string name;  // the name that rules match: "final/AB/volume", "contact/0.25/A/B/area"
  std::uint64_t step = 0;
  double value = 0;  // 0 if not measured
};

/// Returns the number of a line `value`, or the numbers of a line `row`.
std::vector<GoldenNumber> numbersIn(const GoldenItem& item);
/// Returns the numbers of all items.
std::vector<GoldenNumber> numbersIn(const GoldenData& data);

/// Returns the last rule that matches; null if none does.
const ToleranceRule* ruleFor(const std::vector<ToleranceRule>& rules, const GoldenNumber& number);

/// One word of a row: the column's name and its value as in the file, "-" for NULL.
struct RowValue {
  std::string column, text;
};
std::vector<RowValue> valuesOf(const GoldenRow& row);

/// Returns the table's name: "contact" of "contact/area" and of "contact/0.25/A/B".
std::string tableOf(const std::string& name);

}  // namespace morula
