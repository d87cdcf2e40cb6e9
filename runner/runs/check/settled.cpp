#include "check/settled.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/words.h"

namespace morula {

std::string unsettledText(const SettleParameters& asked, const std::vector<SettlingRecord>& settlings) {
  const auto count =
      std::ranges::count_if(settlings, [&](const SettlingRecord& s) { return !(s.residual <= asked.tolerance); });
  if (count == 0) return "";
  const SettlingRecord& farthest = *std::ranges::max_element(settlings, {}, &SettlingRecord::residual);
  return fmt::format(
      "physics.settle: {} of {} ended after {} evaluations above the tolerance of {:.3g}, the farthest at time {:.4g} "
      "with {} at {:.3g}; give more physics.settle.evaluations, or a larger physics.settle.tolerance",
      count, counted(settlings.size(), "settling"), asked.evaluations, asked.tolerance, farthest.time,
      counted(farthest.cells, "cell"), farthest.residual);
}

std::string distanceText(const std::vector<SettlingRecord>& settlings) {
  const auto way = [](const SettlingRecord& s) { return s.displacementLeft.value_or(-1); };
  const auto count = std::ranges::count_if(settlings, [&](const SettlingRecord& s) { return way(s) >= 0; });
  if (count == 0) return "";
  const SettlingRecord& farthest = *std::ranges::max_element(settlings, {}, way);
  return fmt::format(
      "{} measured: from there to a hundredth of the tolerance no vertex goes farther than {:.2g}, at time "
      "{:.4g} with {}, which loses an energy of {:.2g}",
      counted(count, "settling") + (count == 1 ? " was" : " were"), *farthest.displacementLeft, farthest.time,
      counted(farthest.cells, "cell"), farthest.energyLeft.value_or(0));
}

}  // namespace morula
