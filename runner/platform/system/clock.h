#pragma once
// Clocks. On a shared machine only the CPU time of threads tells the cost. Of several measurements the median counts,
// since disturbances of some of them do not change it.
#include <ctime>
#include <vector>

namespace morula {

enum class ClockKind {
  cpu,      // CPU time of this thread alone
  process,  // CPU time of all threads together
  wall,
};

inline double seconds(ClockKind kind) {
  timespec t{};
  clock_gettime(kind == ClockKind::cpu       ? CLOCK_THREAD_CPUTIME_ID
                : kind == ClockKind::process ? CLOCK_PROCESS_CPUTIME_ID
                                             : CLOCK_MONOTONIC,
                &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Returns the time that a call takes [s].
template <class Call>
double timeOf(ClockKind kind, const Call& call) {
  const double before = seconds(kind);
  call();
  return seconds(kind) - before;
}

/// Returns the median; NaN for no values.
double median(std::vector<double> values);

/// Returns the spread of measurements [1]: half the distance between the quartiles, over the median.
double spread(std::vector<double> values);

}  // namespace morula
