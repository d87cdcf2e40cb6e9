#pragma once
// Structs with one list of their members, beside the struct: writing, reading and hashing go by it. A member that is
// missing in the list does not compile.
//
//   struct GrowthParameters { … };
//   MORULA_MEMBERS(GrowthParameters, rate, until)
#include <tuple>

#include "base/record.h"

/// Defines `members`, a tuple of references to all members in the order of the struct, and `memberNames`, their names
/// in a text: "rate, until".
#define MORULA_MEMBERS(Struct, ...)            \
  template <::morula::IsA<Struct> MorulaOwner> \
  auto members(MorulaOwner& morulaOwner) {     \
    auto& [__VA_ARGS__] = morulaOwner;         \
    return std::tie(__VA_ARGS__);              \
  }                                            \
  constexpr const char* memberNames(const Struct*) { return #__VA_ARGS__; }

namespace morula {

template <class T>
concept HasMembers = requires(T& value) {
  members(value);
};

}  // namespace morula
