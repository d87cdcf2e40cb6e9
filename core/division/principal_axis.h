#pragma once
// The direction in which a cloud of points is longest.
#include <span>

#include "base/vec3.h"

namespace morula {

/// [1] The two largest extents over each other, 1 or more: root mean square distances from the mean along the
/// principal axes. 1 for a sphere and a disc; infinite for points on a line.
double extentRatio(std::span<const Point> points);

/// A direction to which no symmetric shape lies at right angles.
constexpr Vector ownSide{1, 0.55, 0.2};

/// Returns the direction of a line that points to the side of `ownSide`, so that rounding does not decide.
Vector towardsOwnSide(const Vector& line);

/// The unit eigenvector of the largest eigenvalue of the points' covariance. It points to the side of `ownSide`. Where
/// the largest eigenvalues agree to 1e-6 (a sphere, a disc), it is the vector of their eigenspace nearest to
/// x, or to y where x is far from all of them.
Vector principalAxis(std::span<const Point> points);

/// [length] The extents along the three principal axes, root mean square distances from the mean, the largest first.
Vector principalExtents(std::span<const Point> points);

}  // namespace morula
