#pragma once
// Random tilts of axes.
#include "base/random.h"

namespace morula {

/// Returns `axis` (of length 1), tilted at random. The result is drawn from the von Mises–Fisher distribution [Fisher
/// 1953], the bell curve of directions. Its concentration is κ = 1/σ² with σ = `degrees` in radians: for small σ the
/// deviations along both tangents are normal with the standard deviation σ. The mean of the cosine to the axis is
/// coth κ − 1/κ. The draw alone decides the deviation relative to the axis.
///
/// Draws by inversion [Ulrich 1984; Wood 1994; Jakob 2012]: w = 1 + ln(u + (1 − u) e^{−2κ})/κ along the axis, and a
/// uniform angle about it.
Vector tiltAxis(const Vector& axis, double degrees, const Draw& draw);

}  // namespace morula
