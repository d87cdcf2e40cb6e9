#pragma once
// Functions made of + − × ÷ and square roots only, because the library's others differ between machines in
// the last bit.
#include <bit>
#include <cstdint>
#include <limits>

namespace morula {

/// Cube root of a positive, normal number, to within 1 ulp and the same bits everywhere. A first estimate from the
/// exponent is right to 4 %; each of five Newton iterations for x³ = a then doubles the correct digits, where four are
/// enough. They use a/x² and not x³ − a, because the cube of an estimate that is too large may overflow.
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

/// e^a, to within 1 ulp (4e-16 of e^a), also where the result is subnormal: with a = k ln 2 + r and |r| ≤ ½ ln 2
///
///   e^a = 2^k (1 + r + r²/2! + … + r¹⁴/14!)
///
/// whose next term is below 1e-18. ln 2 is taken off in two parts, the first short enough for k times it to be
/// exact. 0 below −745.2, ∞ above 709.8, NaN for NaN.
inline double exponential(double a) {
  constexpr double ln2High = 0x1.62E42FEEp-1, ln2Low = 0x1.A39EF35793C76p-33, perLn2 = 1.4426950408889634;
  if (!(a <= 709.79)) return a > 0 ? std::numeric_limits<double>::infinity() : a;
  if (a < -745.2) return 0;
  const int k = static_cast<int>(a * perLn2 + (a < 0 ? -0.5 : 0.5));
  const double high = a - k * ln2High, low = k * ln2Low, r = high - low;
  double series = 0;
  for (int n = 14; n >= 2; --n) series = (series + 1) * r / n;
  const double whole = 1 + ((high - r) - low + r * series + r);
  const auto powerOfTwo = [](int n) { return std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52); };
  return whole * powerOfTwo(k / 2) * powerOfTwo(k - k / 2);  // 2^k alone may be too large, or subnormal
}

struct SineAndCosine {
  double sine, cosine;
};

/// Sine and cosine of an angle [radian], each to within 2 ulp where |angle| ≤ 1e5: angle = k π/2 + r with |r| ≤ π/4,
/// and there
///
///   sin r = r − r³/3! + … + r¹⁷/17!,   cos r = 1 − r²/2! + … + r¹⁶/16!
///
/// whose next terms are below 1e-19. π/2 is taken off in three parts, the first two short enough for k times them to be
/// exact. Returns NaN for an angle that is NaN or beyond ±1e9.
inline SineAndCosine sineAndCosine(double angle) {
  constexpr double high = 0x1.921FB544p0, middle = 0x1.0B4611A6p-34, low = 0x1.3198A2E037073p-69;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(angle >= -1e9 && angle <= 1e9)) return {nan, nan};
  const int k = static_cast<int>(angle * 0.6366197723675814 + (angle < 0 ? -0.5 : 0.5));
  // The remainder, and what rounding took from it.
  const double first = angle - k * high, second = k * middle, sum = first - second;
  const double error = (first - sum) - second;
  const double rest = k * low - error, r = sum - rest, tail = (sum - r) - rest;
  double odd = 0, even = 0;
  for (int n = 17; n >= 3; n -= 2) odd = (1 + odd) * (-r * r) / (n * (n - 1));
  for (int n = 16; n >= 4; n -= 2) even = (1 + even) * (-r * r) / (n * (n - 1));
  const double half = 0.5 * r * r, most = 1 - half;
  const double sine = r + (r * odd + tail);
  const double cosine = most + (((1 - most) - half) - half * even - r * tail);
  switch (k & 3) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case 2: return {-sine, -cosine};
    default: return {-cosine, sine};
  }
}

/// The largest power of two that does not exceed a positive, normal number.
inline double powerOfTwoBelow(double a) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7FF0000000000000u);
}

}  // namespace morula
