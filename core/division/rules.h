#pragma once
// The rule by which a cell divides.
#include <string_view>

#include "division/parameters.h"

namespace morula {

/// The first rule that fits a cell with these substances (names with single spaces between them); null if none does.
const DivisionRule* ruleFor(const DivisionParameters& division, std::string_view substances);

/// Its plane, or that of cells that no rule names.
const PlaneChoice& planeFor(const DivisionParameters& division, std::string_view substances);

/// Daughter A's share as it can be cut.
constexpr double minShare = 0.1, largestShare = 0.9;

}  // namespace morula
