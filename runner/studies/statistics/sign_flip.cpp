#include "statistics/sign_flip.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/error.h"

namespace morula {
namespace {

constexpr std::size_t maxTried = 20;

}  // namespace

double smallestSignFlipP(std::size_t n) { return std::ldexp(1.0, 1 - static_cast<int>(n)); }

double tieOf(std::span<const double> numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  return 1e-12 * largest;
}

bool repeats(std::span<const double> differences, std::size_t length) {
  const double tie = tieOf(differences);
  const std::size_t n = differences.size() / length;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double same = 0, opposite = 0;
      for (std::size_t k = 0; k < length; ++k) {
        const double a = differences[i * length + k], b = differences[j * length + k];
        same = std::max(same, std::abs(a - b)), opposite = std::max(opposite, std::abs(a + b));
      }
      if (std::min(same, opposite) <= tie) return true;
    }
  return false;
}

double signFlipP(std::span<const double> differences, std::size_t length) {
  MORULA_CHECK(length > 0 && !differences.empty() && differences.size() % length == 0, "n vectors");
  const std::size_t n = differences.size() / length;
  if (n > maxTried) return smallestSignFlipP(n);
  std::vector<double> sum(length, 0.0), sign(n, 1.0);
  double size = 0;  // max of a sum
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < length; ++k)
      sum[k] += differences[i * length + k], size += std::abs(differences[i * length + k]);
  const auto square = [&] {
    double s = 0;
    for (const double x : sum) s += x * x;
    return s;
  };
  // Tries half of the choices: the others have all signs changed. A Gray code changes one sign from each to the next.
  const double least = square() - 1e-9 * size * size;
  std::uint64_t asFar = 1;
  const std::uint64_t choices = std::uint64_t{1} << (n - 1);
  for (std::uint64_t c = 1; c < choices; ++c) {
    const auto i = static_cast<std::size_t>(std::countr_zero(c));
    sign[i] = -sign[i];
    for (std::size_t k = 0; k < length; ++k) sum[k] += 2 * sign[i] * differences[i * length + k];
    asFar += square() >= least;
  }
  return static_cast<double>(asFar) / static_cast<double>(choices);
}

}  // namespace morula
