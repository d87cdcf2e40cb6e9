#include "golden/toleranced_numbers.h"

#include "files/text.h"
#include "golden/read_number.h"

namespace morula {

std::string tableOf(const std::string& name) { return name.substr(0, name.find('/')); }

std::vector<RowValue> valuesOf(const GoldenRow& row) {
  std::vector<RowValue> values;
  for (const std::string& word : partsOf(row.values.text, ' '))
    if (const auto equals = word.find('='); equals != word.npos)
      values.push_back({word.substr(0, equals), word.substr(equals + 1)});
  return values;
}

std::vector<GoldenNumber> numbersIn(const GoldenItem& item) {
  if (const auto* value = std::get_if<GoldenValue>(&item))
    return {{goldenText(value->name), value->step, value->value.value_or(0)}};
  std::vector<GoldenNumber> numbers;
  if (const auto* row = std::get_if<GoldenRow>(&item))
    for (const RowValue& value : valuesOf(*row))
      if (const auto number = readReal(value.text))
        numbers.push_back({row->name + '/' + value.column, row->step, *number});
  return numbers;
}

std::vector<GoldenNumber> numbersIn(const GoldenData& data) {
  std::vector<GoldenNumber> all;
  for (const GoldenItem& item : data.items)
    for (GoldenNumber& number : numbersIn(item)) all.push_back(std::move(number));
  return all;
}

const ToleranceRule* ruleFor(const std::vector<ToleranceRule>& rules, const GoldenNumber& number) {
  const ToleranceRule* holds = nullptr;
  for (const ToleranceRule& rule : rules)
    if (rule.matches(number.name, number.step)) holds = &rule;
  return holds;
}

}  // namespace morula
