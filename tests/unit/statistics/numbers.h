#pragma once
// Random numbers of simulated studies, and counts of what happens in them.
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/random.h"

namespace morula::test {

/// The number of studies from which most counts are made.
constexpr int studies = 4000;

/// Independent random numbers, in the order of the calls.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : seed_(seed) {}
  double normal() { return randomNormal({seed_, {}}, next_++); }
  double exponential() { return -std::log(1 - unit()); }  // mean 1
  /// Returns a normal deviate that is not cut off at 3, by the method of Box and Muller.
  double farNormal() {
    const double size = std::sqrt(2 * exponential());
    return size * std::cos(6.283185307179586 * unit());
  }
  double coin() { return unit() < 0.5 ? 0 : 1; }
  double shareOf32() {
    double found = 0;
    for (int i = 0; i < 32; ++i) found += unit() < 0.9;
    return found / 32;
  }
  double unit() { return randomUnit({seed_, {}}, next_++); }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

template <class Draw>
std::vector<double> sample(std::size_t n, const Draw& draw) {
  std::vector<double> values(n);
  for (double& v : values) v = draw();
  return values;
}

/// Returns how many of the simulated studies have the event, in percent.
template <class Study>
double percent(const Study& happens, int of = studies) {
  int count = 0;
  for (int i = 0; i < of; ++i) count += happens(std::uint64_t(i));
  return 100. * count / of;
}

}  // namespace morula::test
