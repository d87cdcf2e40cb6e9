#pragma once
// How far apart two sets of points are when one has been laid upon the other as well as can be.
#include <optional>
#include <span>

#include "base/vec3.h"

namespace morula {

struct Superposition {
  double distance;  // [length] root mean square of what is left between the points, turned and moved, not scaled
  double shape;     // [1] the same, the points also scaled, over the root mean square radius of the others
  double scale;     // [1] by which the points are scaled for that
};

/// Turns and moves `points` so that the sum of their squared distances from `others` is least [Kabsch 1976], by the
/// unit quaternion that does it [Horn 1987]: never a reflection. As many points as others; absent with fewer than three
/// pairs, or where either are all in one place.
std::optional<Superposition> superpose(std::span<const Point> points, std::span<const Point> others);

}  // namespace morula
