#pragma once
// From a name to the value of an enumeration that has rows [choice.h].
#include <optional>
#include <string_view>
#include <vector>

#include "base/choice.h"

namespace morula {

template <class E>
std::optional<E> valueNamed(std::string_view name) {
  for (const auto& row : choices<E>)
    if (name == row.name) return row.value;
  return std::nullopt;
}

/// Throws InputError: "'sold' is not known; needs solid, wireframe or both; did you mean solid?"
[[noreturn]] void refuseName(std::string_view word, const std::vector<std::string>& names);

/// Throws InputError for any other name.
template <class E>
E parseChoice(std::string_view word) {
  if (const auto value = valueNamed<E>(word)) return *value;
  std::vector<std::string> names;
  for (const auto& row : choices<E>) names.emplace_back(row.name);
  refuseName(word, names);
}

}  // namespace morula
