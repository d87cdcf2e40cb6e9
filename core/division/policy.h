#pragma once
// Division policies: the plane along which a cell divides.
#include <cstdint>
#include <memory>

#include "biology/cell_context.h"
#include "biology/variation.h"
#include "division/cut.h"
#include "division/parameters.h"

namespace morula {

class DivisionPolicy {
 public:
  virtual ~DivisionPolicy() = default;
  /// Returns the cut of this cell, which has a body. The call sees the instant before any cell divides, and the
  /// answer depends on nothing else, so that the order of calls cannot matter.
  virtual Cut findCut(const CellContext& cell) const = 0;
};

/// Makes a policy with one plane for all cells. Throws InputError for an axis of length 0.
std::unique_ptr<DivisionPolicy> makePlanePolicy(const PlaneChoice& choice, std::uint64_t seed);

/// Returns the policy that takes plane, share, tilt and deviations of each cell from the first rule that fits it
/// (rules.cpp). Throws InputError for an axis of length 0, and for a share that is or may vary below 0.1 or above 0.9.
std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& parameters, std::uint64_t seed,
                                                   const VariationParameters& variation = {});

}  // namespace morula
