#pragma once
// Kernels for the machine's peak speeds, one table per instruction set: only multiplications and additions in
// registers, only memory, or only instructions.
#include <cstddef>

#include "base/isa.h"

namespace morula {

struct PeakKernels {
  int operationsPerTurn;  // multiplications and additions of doubles, without fused ones
  /// Runs `turns` turns and returns a number made of all results, so that none is optimised away.
  double (*multiplyAdd)(long turns);
  int rootsPerTurn;  // pairs of one square root and one division
  double (*divideRoot)(long turns);
  /// Computes a ← b + 2c: 24 bytes per element. `count`: a multiple of 8. Arrays begin on cache lines.
  void (*triad)(double* a, const double* b, const double* c, std::size_t count);
  int instructionsPerTurn;
  /// Runs `turns` turns of instructions that need no unit, so that only fetching and decoding them takes time.
  double (*issue)(long turns);
};

const PeakKernels& peakKernels(Isa isa);

}  // namespace morula
