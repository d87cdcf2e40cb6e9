#pragma once
#include <cmath>

namespace morula {

/// The largest of many numbers, for one CHECK over all of them. A NaN is the worst there is.
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
