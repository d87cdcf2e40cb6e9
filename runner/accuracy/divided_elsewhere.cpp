#include "accuracy/divided_elsewhere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morula {

std::optional<DividedElsewhere> findDividedElsewhere(std::span<const DivisionRecord> divisions,
                                                     std::span<const DivisionRecord> reference,
                                                     double least) {
  for (const DivisionRecord& there : reference) {  // by time
    const auto here = std::find_if(divisions.begin(), divisions.end(),
                                   [&](const DivisionRecord& d) { return d.path == there.path; });
    if (here == divisions.end()) continue;
    // To daughter A: the same plane with the daughters on the other sides is as far as can be.
    const double cosine = std::clamp(dot(here->axis, there.axis), -1.0, 1.0);
    const double angle = std::acos(cosine) * 180 / std::numbers::pi;
    if (angle > least) return DividedElsewhere{there.path, there.time, angle, there.extentRatio};
  }
  return {};
}

}  // namespace morula
