#pragma once
// Functions made of + − × ÷ and square roots only, because the library's others differ between machines in
// the last bit.
#include <bit>
#include <cstdint>
#include <limits>

namespace morula {

/// Cube root of a positive, normal number, to within 1 ulp and the same bits everywhere: a guess from the
/// exponent, right to 4 %, and Newton's iteration for x³ = a, which doubles the correct digits in each iteration:
/// four suffice, and one more is a margin. Written with a/x², not x³ − a, for the cube of a guess that
/// is too large may overflow.
inline double cubeRoot(double a) {
  const auto bits = std::bit_cast<std::uint64_t>(a);
  double x = std::bit_cast<double>(bits / 3 + 0x2A9F7893782DA1CEu);
  for (int turn = 0; turn < 5; ++turn) x = x - (x - a / (x * x)) / 3;
  return x;
}

/// ln a, to within 4e-16 (1 + |ln a|): with a = m 2^e and √½ ≤ m < √2
///
///   ln a = e ln 2 + 2 artanh s,   s = (m − 1)/(m + 1),   artanh s = s + s³/3 + s⁵/5 + …
///
/// where s² < 0.0295, so that twelve terms are exact to 1e-19. −∞ for 0, NaN below.
inline double naturalLog(double a) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), ln2 = 0.6931471805599453;
  if (!(a > 0)) return a == 0 ? -infinity : std::numeric_limits<double>::quiet_NaN();
  if (a == infinity) return a;
  if (a < std::numeric_limits<double>::min()) return naturalLog(a * 0x1p54) - 54 * ln2;
  const auto bits = std::bit_cast<std::uint64_t>(a);
  int e = static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFu) | 0x3FF0000000000000u);  // 1 ≤ m < 2
  if (m > 1.4142135623730951) m *= 0.5, ++e;
  const double s = (m - 1) / (m + 1);
  double series = 0;
  for (int k = 23; k >= 1; k -= 2) series = series * (s * s) + 1.0 / k;
  return e * ln2 + 2 * s * series;
}

/// The largest power of two that does not exceed a positive, normal number.
inline double powerOfTwoBelow(double a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7FF0000000000000u);
}

}  // namespace morula
