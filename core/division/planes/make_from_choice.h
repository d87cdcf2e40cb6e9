#pragma once
// The `make` of a row of the table of planes (DivisionPlaneKind).
#include <type_traits>

#include "division/policy.h"

namespace morula {

/// A policy made from the scenario's choice, or from the seed, or, where it needs neither, from nothing.
template <class Policy>
std::unique_ptr<DivisionPolicy> makeFromChoice([[maybe_unused]] const PlaneChoice& choice,
                                               [[maybe_unused]] std::uint64_t seed) {
  if constexpr (std::is_constructible_v<Policy, const PlaneChoice&>) return std::make_unique<Policy>(choice);
  else if constexpr (std::is_constructible_v<Policy, std::uint64_t>) return std::make_unique<Policy>(seed);
  else return std::make_unique<Policy>();
}

}  // namespace morula
