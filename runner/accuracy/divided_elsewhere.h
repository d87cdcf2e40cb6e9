#pragma once
// Two runs whose cells divide at the same times, but across other planes: a round cell has no longest
// extent, and a small difference chooses one. What comes later then differs by a large share of a radius,
// whatever the time step.
#include <optional>
#include <span>

#include "division/record.h"

namespace morula {

struct DividedElsewhere {
  CellPath mother;
  double time = 0;                    // [time] of the division in the reference
  double angle = 0;                   // [degrees] between the two axes to daughter A, up to 180
  std::optional<double> extentRatio;  // [1] of the reference's mother [DivisionRecord]
};

/// The first division whose axes are more than `least` degrees apart.
std::optional<DividedElsewhere> findDividedElsewhere(std::span<const DivisionRecord> divisions,
                                                     std::span<const DivisionRecord> reference,
                                                     double least = 1);

}  // namespace morula
