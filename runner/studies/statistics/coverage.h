#pragma once
// How often the 95 % interval of a mean (means.h) holds it. Few values do not show that their distribution is skewed or
// has a rare group: then the interval is Student's and too narrow.
#include <cstddef>
#include <optional>

namespace morula {

/// Percent of samples of n values whose interval holds the mean.
struct Coverage {
  std::size_t n = 0;
  double normal = 95;
  double exponential = 0;  // skewness 2
  double logNormal = 0;    // e^z of a normal deviate z: skewness 6
  double oneInTen = 0;     // 1 in one run of ten, otherwise 0, each with a normal deviate of 0.02
};

/// Returns the coverage for the largest tabled number of values that is not above `n`; absent below 2. The table is
/// from 40,000 samples each; tests/unit/statistics/coverage_test.cpp draws 4,000, which agree to within 1.5 %.
std::optional<Coverage> coverageOf(std::size_t n);

}  // namespace morula
