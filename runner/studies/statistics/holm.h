#pragma once
// Several tests at once: the more are made, the more of them find a difference where there is none.
#include <span>
#include <vector>

namespace morula {

/// p-values of a family of tests, corrected so that if those below 0.05 are called differences, at most 5 % of such
/// families have any false one among them [Holm 1979]: in rising order the i-th of m (from 0) is taken (m − i) times, is at least
/// the one before, and at most 1. In the order given.
std::vector<double> correctHolm(std::span<const double> p);

}  // namespace morula
