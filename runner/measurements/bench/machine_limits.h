#pragma once
// The machine's own limits, measured in the same run and between the same other measurements.
#include <cstddef>
#include <map>
#include <vector>

#include "base/aligned.h"
#include "base/isa.h"

namespace morula {

struct MachineLimits {
  struct Arithmetic {
    double operations;  // [1/s] multiplications and additions, not fused
    double roots;       // [1/s] pairs of a square root and a division
  };
  std::map<Isa, Arithmetic> arithmetic;     // by one thread
  std::map<std::size_t, double> bandwidth;  // [byte/s] by one thread, by the size of what it goes over [byte]

  /// The bandwidth for data of a size: that of the smallest measured size that holds them.
  double bandwidthFor(double bytes) const;
};

/// How many processors a loop on so many threads is given at this moment, others being busy too: CPU time
/// over the wall's.
double processorsFor(int threads);

class LimitMeter {
 public:
  explicit LimitMeter(std::vector<Isa> isas);
  /// Measures everything once more: some milliseconds.
  void sample();
  /// The medians so far.
  MachineLimits limits() const;

 private:
  struct Samples {
    std::vector<double> operations, roots;
  };
  std::map<Isa, Samples> arithmetic_;
  std::map<std::size_t, std::vector<double>> bandwidth_;
  AlignedVector<double> memory_;
};

}  // namespace morula
