#pragma once
// Multiples of an interval in time: 0, every, 2·every, …
#include <cstdint>
#include <optional>

namespace morula {

/// Returns the smallest n for which n·every, rounded to a double, is larger than `time` ≥ 0; every > 0. The number of
/// operations is fixed, however small the interval. Returns 2^53 if n would not be exact as a double: the next multiple
/// of so short an interval cannot be told from `time`.
inline std::uint64_t firstMultipleAfter(double time, double every) {
  constexpr double exact = 0x1p53;
  const double quotient = time / every;
  if (!(quotient < exact)) return std::uint64_t(1) << 53;
  // The quotient is off by less than its rounding, and the product may be rounded to the time itself.
  auto n = static_cast<std::uint64_t>(quotient);
  n = n < 2 ? 0 : n - 2;
  for (int i = 0; i < 5 && static_cast<double>(n) * every <= time; ++i) ++n;
  return n;
}

/// Decides when something is due: at 0, every, 2·every, …; never without an interval.
class Schedule {
 public:
  explicit Schedule(std::optional<double> every) : every_(every) {}
  /// The time from which on something is due; absent without an interval.
  std::optional<double> next() const {
    return every_ ? std::optional(static_cast<double>(number_) * *every_) : std::nullopt;
  }
  bool isDue(double time) const { return every_ && time >= *next(); }
  /// Notes that everything due at `time` or before has been done. The next multiple after `time` is due next.
  void pass(double time) {
    if (every_) number_ = firstMultipleAfter(time, *every_);
  }

 private:
  std::optional<double> every_;
  std::uint64_t number_ = 0;
};

}  // namespace morula
