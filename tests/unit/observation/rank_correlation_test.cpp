// Rank correlation against its definition, and properties of ranks.
#include <cmath>

#include "catch.h"
#include "observation/organism_measures.h"
#include "unit/physics/lab.h"

using namespace morula;

namespace {

/// Returns the rank: 1 + the number of smaller values + half the number of other equal values.
double rankOf(const std::vector<double>& values, double value) {
  double rank = 0.5;
  for (double other : values) rank += other < value ? 1 : other == value ? 0.5 : 0;
  return rank;
}

double bruteForce(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double a = rankOf(x, x[i]), b = rankOf(y, y[i]);
    sx += a, sy += b, sxx += a * a, syy += b * b, sxy += a * b;
  }
  return (n * sxy - sx * sy) / std::sqrt((n * sxx - sx * sx) * (n * syy - sy * sy));
}

}  // namespace

TEST_CASE("Rank correlation is that of its definition, ties and all") {
  for (std::uint32_t key = 1; key < 40; ++key) {
    std::vector<double> x, y;
    for (std::uint32_t i = 0; i < 3 + 2 * key; ++i) {
      x.push_back(std::floor(4 * noise(i, key)));  // many ties
      y.push_back(x.back() + 3 * noise(i, key + 100));
    }
    CHECK(*rankCorrelation(x, y) == Approx(bruteForce(x, y)).margin(1e-12));
    CHECK(*rankCorrelation(x, y) == Approx(*rankCorrelation(y, x)).margin(1e-14));
  }
}

TEST_CASE("Any rising curve gives 1, any falling one −1, and a constant nothing") {
  const std::vector<double> x{-3, 0, 0.5, 2, 10}, cubes{-27, 0, 0.125, 8, 1000}, down{5, 4, 3, 2, 1}, flat(5, 1);
  CHECK(*rankCorrelation(x, cubes) == Approx(1).epsilon(1e-15));
  CHECK(*rankCorrelation(x, down) == Approx(-1).epsilon(1e-15));
  CHECK_FALSE(rankCorrelation(x, flat));
  CHECK_FALSE(rankCorrelation(flat, x));
  CHECK_FALSE(rankCorrelation({}, {}));
}

TEST_CASE("Rounding decides nothing: what is equal but for it has one rank") {
  const std::vector<double> x{1, 2, 2, 3}, y{1, 1 + 1e-15, 4, 4 - 1e-15}, exactly{1, 1, 4, 4};
  CHECK(*rankCorrelation(x, y) == *rankCorrelation(x, exactly));
  CHECK(*rankCorrelation(x, std::vector<double>{1, 1.001, 4, 3.999}) != *rankCorrelation(x, exactly));
}
