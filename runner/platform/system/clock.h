#pragma once
// Clocks. On a machine that others use too, only the time that threads were given says what it costs; and
// of several measurements of one thing the middle one counts: what disturbed some of them does not.
#include <ctime>
#include <vector>

namespace morula {

enum class ClockKind {
  cpu,      // of this thread alone
  process,  // of all threads together
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

/// [s] that a call takes.
template <class Call>
double timeOf(ClockKind kind, const Call& call) {
  const double before = seconds(kind);
  call();
  return seconds(kind) - before;
}

/// NaN of nothing.
double median(std::vector<double> values);

/// Half the distance between the quartiles, over the median: how far measurements lay apart. [1]
double spread(std::vector<double> values);

}  // namespace morula
