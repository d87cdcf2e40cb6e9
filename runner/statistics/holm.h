#pragma once
// Several tests at once: the more are made, the more find what is not there.
#include <span>
#include <vector>

namespace morula {

/// p-values corrected so that, with those below 0.05 called differences, one or more false ones are called in at
/// most 5 % of such families [Holm 1979]: in rising order the i-th of m (from 0) is taken (m − i) times, is at least
/// the one before, and at most 1. In the order given.
std::vector<double> correctHolm(std::span<const double> p);

}  // namespace morula
