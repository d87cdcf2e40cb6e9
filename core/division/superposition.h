#pragma once
// The distance of two sets of points when one has been laid upon the other as well as can be.
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"

namespace morula {

struct Superposition {
  double distance;  // [length] root mean square distance of the points from the others, turned and moved, not scaled
  double shape;     // [1] this distance with scaled points, over the root mean square radius of the others
  double scale;     // [1] factor of this scaling
  std::vector<double> distances;  // [length] of each point from its other, turned and moved, not scaled
};

/// Turns and moves `points` so that the sum of their squared distances from `others` is least [Kabsch 1976], by the
/// unit quaternion of [Horn 1987]: never a reflection. Requires as many points as others. Absent with fewer than three
/// pairs, or if either set is all in one place.
std::optional<Superposition> superpose(std::span<const Point> points, std::span<const Point> others);

}  // namespace morula
