#pragma once
// Choices of a scenario: an enumeration with one row per value, and the way from a name to its value.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace morula {

template <class E>
struct Choice {
  E value;
  const char* name;     // the name in scenarios
  const char* meaning;  // the meaning for people, part of a sentence
};

/// [value] The rows of E, in the order of its values; specialised beside each enumeration.
template <class E>
inline constexpr auto choices = nullptr;

template <class E>
constexpr auto valuesOf() {
  std::array<E, choices<E>.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = choices<E>[i].value;
  return values;
}

/// Returns the value's name in scenarios.
template <class E>
constexpr const char* nameOf(E value) {
  return choices<E>[static_cast<std::size_t>(value)].name;
}

/// Returns the value's meaning for people.
template <class E>
constexpr const char* meaningOf(E value) {
  return choices<E>[static_cast<std::size_t>(value)].meaning;
}

/// Returns all names for people: "pair or thesis".
template <class E>
std::string namesOf() {
  std::string list;
  for (const auto& row : choices<E>)
    list += (list.empty() ? "" : &row == &choices<E>.back() ? " or " : ", ") + std::string(row.name);
  return list;
}

template <class E>
std::optional<E> valueNamed(std::string_view name) {
  for (const auto& row : choices<E>)
    if (name == row.name) return row.value;
  return std::nullopt;
}

/// Throws InputError: "'sold' is not known; needs solid, wireframe or both; did you mean solid?"
[[noreturn]] void refuseName(std::string_view word, const std::vector<std::string>& names);

/// Returns the value with this name. Throws InputError if there is none.
template <class E>
E parseChoice(std::string_view word) {
  if (const auto value = valueNamed<E>(word)) return *value;
  std::vector<std::string> names;
  for (const auto& row : choices<E>) names.emplace_back(row.name);
  refuseName(word, names);
}

}  // namespace morula
