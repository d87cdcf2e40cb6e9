#pragma once
// The rule by which a cell divides.
#include <string_view>

#include "base/cell_path.h"
#include "division/parameters.h"

namespace morula {

/// Returns the first rule that fits a cell with this path and these substances (names with single spaces between them); null if none.
const DivisionRule* ruleFor(const DivisionParameters& division, const CellPath& cell, std::string_view substances);

/// Returns the plane of that rule, or of cells that no rule names.
const PlaneChoice& planeFor(const DivisionParameters& division, const CellPath& cell, std::string_view substances);

/// Bounds of daughter A's share that can be cut.
constexpr double minShare = 0.1, largestShare = 0.9;

}  // namespace morula
