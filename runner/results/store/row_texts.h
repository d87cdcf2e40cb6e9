#pragma once
// The values of a record as texts, field by field, as a database keeps them: −0 is 0, and NaN is NULL.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/number_text.h"
#include "base/record.h"
#include "base/vec3.h"
#include "observation/measure_fields.h"

namespace morula {

/// The texts of a row's columns; absent for NULL.
using RowTexts = std::vector<std::optional<std::string>>;

inline std::optional<std::string> textOfNumber(double value) {
  if (std::isnan(value)) return std::nullopt;
  return exactText(value == 0 ? 0 : value);
}

/// Adds the text of a member, or the texts of a record's fields in the order of its list, which is its table's order.
template <class T>
void addTexts(RowTexts& to, const T& value) {
  if constexpr (Record<T>) {
    listFields(value, [&](const FieldInfo&, const auto& member) { addTexts(to, member); });
  } else if constexpr (IsMeasures<T>) {
    value.each([&](const auto&, std::size_t i) { addTexts(to, value.of.values[i]); });
  } else if constexpr (requires { value.isAbsent; }) {
    if (value.isAbsent) to.emplace_back();
    else addTexts(to, value.of);
  } else if constexpr (IsOptional<T>) {
    if (value) addTexts(to, *value);
    else to.emplace_back();
  } else if constexpr (HasChoices<T>) {
    to.emplace_back(nameOf(value));
  } else if constexpr (IsTemplate<T, AnyReal> || IsTemplate<T, AllBits>) {
    addTexts(to, value.of);
  } else if constexpr (IsTemplate<T, TextOf> || IsTemplate<T, BytesOf>) {
    to.emplace_back(std::string(value.write()));
  } else if constexpr (std::same_as<T, Vector>) {
    for (const double x : {value.x, value.y, value.z}) to.push_back(textOfNumber(x));
  } else if constexpr (std::same_as<T, Hash> || std::same_as<T, CellPath>) {
    to.emplace_back(value.text());
  } else if constexpr (std::floating_point<T>) {
    to.push_back(textOfNumber(value));
  } else if constexpr (std::integral<T>) {
    to.emplace_back(std::to_string(value));
  } else {
    to.emplace_back(value);
  }
}

/// Returns the texts of a row: of the context's values, then of the row's own.
template <class Row, class... Context>
RowTexts textsOf(const Row& row, const Context&... context) {
  RowTexts texts;
  (addTexts(texts, context), ...);
  addTexts(texts, row);
  return texts;
}

}  // namespace morula
