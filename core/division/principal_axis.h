#pragma once
// The direction in which a cloud of points is longest.
#include <span>

#include "base/vec3.h"

namespace morula {

/// Returns the ratio [1] of the two largest extents, 1 or more: root mean square distances from the mean along the
/// principal axes. 1 for a sphere and a disc; infinite for points on a line.
double extentRatio(std::span<const Point> points);

/// A direction to which no symmetric shape lies at right angles.
constexpr Vector ownSide{1, 0.55, 0.2};

/// Returns the direction of a line that points to the side of `ownSide`, so that rounding does not decide.
Vector towardsOwnSide(const Vector& line);

/// Returns the unit eigenvector of the largest eigenvalue of the points' covariance. It points to the side of
/// `ownSide`. Where the largest eigenvalues agree to 1e-6 (a sphere, a disc), it is the vector of their eigenspace
/// nearest to x, or to y where x is far from the whole eigenspace.
Vector principalAxis(std::span<const Point> points);

/// Returns root mean square distances [length] from the mean along the three principal axes, the largest first.
Vector principalExtents(std::span<const Point> points);

}  // namespace morula
