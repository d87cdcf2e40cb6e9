#pragma once
#include <optional>
#include <span>

namespace morula {

/// [1] How far y rises with x, whatever the curve: the correlation of their ranks, equal values having the mean of
/// their ranks; −1 to 1 [Spearman 1904]. Neighbours in order that differ by at most 1e-9 of the largest count as equal:
/// rounding must not decide. Absent where all x or all y are equal. As many x as y. O(n log n)
std::optional<double> rankCorrelation(std::span<const double> x, std::span<const double> y);

}  // namespace morula
