#pragma once
// What a scenario's settings change at the end of a run, where chaos leaves only distributions to be compared: lines
// `statistic` of a golden file.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/hash.h"

namespace morula {

/// The mean of a measure at the end under the scenario's settings, less that under other ones, over runs that differ by a
/// small disturbance of the start.
struct GoldenStatistic {
  std::string measure;       // [simulation/measures.h]
  std::string against;       // the label of the other settings: "half-step"
  double difference = 0;     // [the measure's unit]
  double low = 0, high = 0;  // its 95 % interval
  std::uint64_t runs = 0;    // under each of the two

  friend bool operator==(const GoldenStatistic&, const GoldenStatistic&) = default;
};

/// "statistic clone_radius against half-step difference -0.0012 low -0.0041 high 0.0017 runs 8".
std::string write(const GoldenStatistic& statistic);

/// Reads such a line; null for any other, and for an interval whose ends are not in order.
std::optional<GoldenStatistic> readStatistic(std::string_view line);

void add(Hasher& hasher, const GoldenStatistic& statistic);

}  // namespace morula
