#pragma once
// The machine's limits, measured in the same run as the stages and interleaved with them.
#include <cmath>
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
    double instructions = INFINITY;  // [1/s] that the front end can hand on
  };
  std::map<Isa, Arithmetic> arithmetic;     // of one thread
  std::map<std::size_t, double> bandwidth;  // [byte/s] of one thread, by the size of the data [byte]

  /// Returns the bandwidth for data of a size: that of the smallest measured size that holds them.
  double bandwidthFor(double bytes) const;
};

/// Returns the number of processors that a loop on so many threads gets now, beside other processes: CPU time over wall
/// clock time.
double processorsFor(int threads);

class LimitMeter {
 public:
  explicit LimitMeter(std::vector<Isa> isas);
  /// Takes one sample of all limits, which takes some milliseconds.
  void sample();
  /// Returns the medians of all samples.
  MachineLimits limits() const;

 private:
  struct Samples {
    std::vector<double> operations, roots, instructions;
  };
  std::map<Isa, Samples> arithmetic_;
  std::map<std::size_t, std::vector<double>> bandwidth_;
  AlignedVector<double> memory_;
};

}  // namespace morula
