#pragma once
// The direction in which a cloud of points is longest.
#include <span>

#include "base/vec3.h"

namespace morula {

/// The unit eigenvector of the largest eigenvalue of the points' covariance. Its largest component is positive. Where
/// the largest eigenvalues agree to 1e-6 (a sphere, a disc), rounding must not decide: it is the vector of their
/// eigenspace nearest to x, or to y where x is at right angles to it.
Vector principalAxis(std::span<const Point> points);

}  // namespace morula
