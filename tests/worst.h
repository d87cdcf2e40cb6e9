#pragma once
#include <cmath>

namespace morula {

/// The largest of many numbers, for one CHECK over all of them. NaN counts as largest.
class Worst {
 public:
  void see(double x) {
    if (!std::isnan(value_) && !(x <= value_)) value_ = x;
  }
  operator double() const { return value_; }

 private:
  double value_ = 0;
};

}  // namespace morula
