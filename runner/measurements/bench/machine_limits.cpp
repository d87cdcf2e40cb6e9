#include "bench/machine_limits.h"

#include <iterator>

#include "base/parallel.h"
#include "bench/peak_kernels.h"
#include "system/clock.h"

namespace morula {

MORULA_TABLES(PeakKernels, peak, tables, )

const PeakKernels& peakKernels(Isa isa) { return tables[isa]; }

namespace {

// [byte] sizes from within the first level cache to beyond the last
constexpr std::size_t sizes[] = {24u << 10, 192u << 10, 768u << 10, 3u << 20, 12u << 20, 24u << 20, 96u << 20};
constexpr std::size_t largest = sizes[std::size(sizes) - 1];
constexpr double sampleSeconds = 1e-3;  // [s] min time of one sample, so that the clock's cost does not matter

volatile double sink;  // keeps the compiler from dropping results

/// Returns the turns per second of a kernel, over as many turns as take long enough.
template <class Kernel>
double rate(const Kernel& kernel, long turns = 1000) {
  for (;; turns *= 4)
    if (const double time = timeOf(ClockKind::cpu, [&] { sink = kernel(turns); }); time >= sampleSeconds)
      return static_cast<double>(turns) / time;
}

double measureBandwidth(AlignedVector<double>& memory, std::size_t bytes) {
  const std::size_t count = bytes / 24 / 8 * 8;
  double *a = memory.data(), *b = a + count, *c = b + count;
  const auto& kernels = peakKernels(bestIsa());
  const auto triads = [&](long turns) {
    for (long t = 0; t < turns; ++t) kernels.triad(a, b, c, count);
    return a[0];
  };
  triads(1);
  return rate(triads, 1) * static_cast<double>(24 * count);
}

}  // namespace

double MachineLimits::bandwidthFor(double bytes) const {
  for (const auto& [size, rate] : bandwidth)
    if (bytes <= static_cast<double>(size)) return rate;
  return bandwidth.rbegin()->second;
}

double processorsFor(int threads) {
  const auto turns = static_cast<long>(5e-3 * rate(peakKernels(Isa::scalar).multiplyAdd));
  std::vector<double> results(static_cast<std::size_t>(threads));
  const double before = seconds(ClockKind::process);
  const double wall = timeOf(ClockKind::wall, [&] {
    parallelFor(threads, threads, [&](int i) { results[i] = peakKernels(Isa::scalar).multiplyAdd(turns); });
  });
  sink = results.back();
  return (seconds(ClockKind::process) - before) / wall;
}

LimitMeter::LimitMeter(std::vector<Isa> isas) : memory_(largest / sizeof(double), 1.0) {
  for (const Isa isa : isas) arithmetic_[isa];
  for (const std::size_t size : sizes) bandwidth_[size];
}

void LimitMeter::sample() {
  for (auto& [isa, samples] : arithmetic_) {
    const PeakKernels& k = peakKernels(isa);
    samples.operations.push_back(rate(k.multiplyAdd) * k.operationsPerTurn);
    samples.roots.push_back(rate(k.divideRoot) * k.rootsPerTurn);
    samples.instructions.push_back(rate(k.issue) * k.instructionsPerTurn);
  }
  for (auto& [size, samples] : bandwidth_) samples.push_back(measureBandwidth(memory_, size));
}

MachineLimits LimitMeter::limits() const {
  MachineLimits limits;
  for (const auto& [isa, samples] : arithmetic_)
    limits.arithmetic[isa] = {median(samples.operations), median(samples.roots), median(samples.instructions)};
  for (const auto& [size, samples] : bandwidth_) limits.bandwidth[size] = median(samples);
  return limits;
}

}  // namespace morula
