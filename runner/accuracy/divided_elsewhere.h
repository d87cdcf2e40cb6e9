#pragma once
// Two runs whose cells divide at the same times, but across other planes: a round cell has no longest
// extent, and rounding chooses one. What comes later then differs by a large share of a radius, whatever the
// time step.
#include <optional>

#include "accuracy/trial.h"

namespace morula {

struct DividedElsewhere {
  CellPath mother;
  double time = 0;         // [time] of the division
  double angle = 0;        // [degrees] between the two planes
  double extentRatio = 0;  // of the mother's two largest extents, at the last comparison before; 1: ambiguous
};

/// The first division whose planes are more than `least` degrees apart. Planes are seen by their daughters'
/// centroids at the first comparison after the division.
std::optional<DividedElsewhere> findDividedElsewhere(const Trial& trial, const Trial& reference,
                                                     double least = 15);

/// The largest extent over the second largest, as standard deviations of the vertices along the principal
/// axes. [1]
double measureExtentRatio(const Mesh& surface);

}  // namespace morula
