#include "check/settled.h"

#include <fmt/format.h>

#include <algorithm>

#include "document/words.h"

namespace morula {

std::string unsettledText(const SettleParameters& asked, const std::vector<SettlingRecord>& settlings) {
  const auto count = std::ranges::count_if(
      settlings, [&](const SettlingRecord& s) { return !(s.residual <= asked.tolerance); });
  if (count == 0) return "";
  const SettlingRecord& farthest = *std::ranges::max_element(settlings, {}, &SettlingRecord::residual);
  return fmt::format(
      "physics.settle: {} of {} ended after {} evaluations above the tolerance of {:.3g}, the farthest at "
      "time {:.4g} with "
      "{} at {:.3g}; give more physics.settle.evaluations, or a larger physics.settle.tolerance",
      count, counted(settlings.size(), "settling"), asked.evaluations, asked.tolerance, farthest.time,
      counted(farthest.cells, "cell"), farthest.residual);
}

}  // namespace morula
