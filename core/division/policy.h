#pragma once
// Where a cell divides.
#include <cstdint>
#include <memory>

#include "biology/cell_context.h"
#include "division/cut.h"
#include "division/parameters.h"

namespace morula {

class DivisionPolicy {
 public:
  virtual ~DivisionPolicy() = default;
  /// Where this cell, which has a body, is to be cut. Asked of the instant before any cell divides; the
  /// answer depends on nothing else, so the order in which cells are asked cannot matter.
  virtual Cut findCut(const CellContext& cell) const = 0;
};

/// One plane for all cells. Throws InputError for an axis of length 0.
std::unique_ptr<DivisionPolicy> makePlanePolicy(const PlaneChoice& choice, std::uint64_t seed);

/// For each cell the plane of the first rule that fits her. Throws InputError for an axis of length 0.
std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& parameters, std::uint64_t seed);

}  // namespace morula
