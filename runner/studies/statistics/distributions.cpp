#include "statistics/distributions.h"

#include <cmath>

#include "base/maths.h"

namespace morula {
namespace {

/// Computes the continued fraction of the incomplete beta function by Lentz's method, which converges fast for x < (a +
/// 1)/(a + b + 2).
double betaFraction(double a, double b, double x) {
  constexpr double tiny = 1e-300, close = 1e-16;
  const auto awayFromZero = [](double v) { return v < tiny && v > -tiny ? tiny : v; };
  double c = 1, d = 1 / awayFromZero(1 - (a + b) * x / (a + 1)), fraction = d;
  for (int m = 1; m < 100'000; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / awayFromZero(1 + even * d);
    c = awayFromZero(1 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / awayFromZero(1 + odd * d);
    c = awayFromZero(1 + odd / c);
    const double factor = d * c;
    fraction *= factor;
    if (factor - 1 < close && factor - 1 > -close) break;
  }
  return fraction;
}

/// Returns where a rising function passes `wanted`, by halving [low, high] until no number lies between its ends.
template <class Function>
double whereItPasses(double wanted, double low, double high, const Function& rises) {
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) return middle;
    (rises(middle) < wanted ? low : high) = middle;
  }
}

}  // namespace

double logGamma(double a) {
  double product = 1;  // a (a + 1) … below 16: at most 16!, far from overflow
  while (a < 16) product *= a, a += 1;
  const double r = 1 / a, r2 = r * r;
  // B₂ₖ / (2k (2k − 1) a^(2k−1)); the next term is below 1e-19 for a ≥ 16.
  const double series =
      r * (1.0 / 12 +
           r2 * (-1.0 / 360 +
                 r2 * (1.0 / 1260 + r2 * (-1.0 / 1680 + r2 * (1.0 / 1188 + r2 * (-691.0 / 360360 + r2 / 156))))));
  constexpr double halfLogOfTwoPi = 0.9189385332046727;
  return (a - 0.5) * naturalLog(a) - a + halfLogOfTwoPi + series - naturalLog(product);
}

double incompleteBeta(double a, double b, double x, double y) {
  if (!(x > 0)) return 0;
  if (!(y > 0)) return 1;
  const double logOfBeta = logGamma(a) + logGamma(b) - logGamma(a + b);
  const double front = exponential(a * naturalLog(x) + b * naturalLog(y) - logOfBeta);
  if (x < (a + 1) / (a + b + 2)) return front * betaFraction(a, b, x) / a;
  return 1 - front * betaFraction(b, a, y) / b;
}

double betaQuantile(double share, double a, double b) {
  return whereItPasses(share, 0, 1, [&](double x) { return incompleteBeta(a, b, x, 1 - x); });
}

double studentBeyond(double t, double df) {
  if (std::isinf(t)) return 0;
  const double square = t * t;
  return incompleteBeta(0.5 * df, 0.5, df / (df + square), square / (df + square));
}

double studentAbove(double t, double df) {
  const double half = 0.5 * studentBeyond(t, df);
  return t > 0 ? half : 1 - half;
}

double studentQuantile(double share, double df) {
  if (share == 0.5) return 0;
  if (share < 0.5) return -studentQuantile(1 - share, df);
  double high = 1;
  while (studentAbove(high, df) > 1 - share) high *= 2;
  return whereItPasses(share - 1, 0, high, [&](double t) { return -studentAbove(t, df); });
}

double fisherAbove(double f, double df1, double df2) {
  if (!(f > 0)) return 1;
  if (std::isinf(f)) return 0;
  const double whole = df2 + df1 * f;
  return incompleteBeta(0.5 * df2, 0.5 * df1, df2 / whole, df1 * f / whole);
}

NoncentralFisher::NoncentralFisher(double f, double df1, double df2) : f_(f), df1_(df1), df2_(df2) {
  if (!(f > 0)) return;
  const double a = 0.5 * df2, b = 0.5 * df1, whole = df2 + df1 * f, x = df2 / whole;
  y_ = df1 * f / whole;
  central_ = incompleteBeta(a, b, x, y_);
  more_ = exponential(a * naturalLog(x) + b * naturalLog(y_) - logGamma(a) - logGamma(b + 1) + logGamma(a + b));
}

double NoncentralFisher::above(double lambda) const {
  if (!(f_ > 0)) return 1;
  if (lambda > 1000) {
    const double mean = df1_ + lambda;
    return fisherAbove(f_ * df1_ / mean, mean * mean / (df1_ + 2 * lambda), df2_);
  }
  const double a = 0.5 * df2_, b = 0.5 * df1_;
  double above = central_, more = more_, weight = exponential(-0.5 * lambda), left = 1, sum = 0;
  for (int j = 0; left > 1e-12 && j < 2000; ++j) {
    sum += weight * above, left -= weight;
    above += more;  // I_x(a, b + 1) = I_x(a, b) + x^a y^b / (b B(a, b)) [DLMF 8.17.21]
    more *= y_ * (a + b + j) / (b + j + 1);
    weight *= 0.5 * lambda / (j + 1);
  }
  return sum + left * above;
}

}  // namespace morula
