// Intervals by resampling: against all resamples that there are, and how often they hold the mean.
#include "statistics/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "statistics/distributions.h"

using namespace morula;

TEST_CASE("Every value is chosen equally often, and resamples do not depend on what was asked before") {
  Bootstrap one, other;
  other.choices(4);
  const auto chosen = one.choices(7);
  REQUIRE(chosen.size() == 7 * Bootstrap::resamples);
  CHECK(std::ranges::equal(chosen, other.choices(7)));
  for (std::uint16_t v = 0; v < 7; ++v)  // 10,000 expected, standard deviation 93
    CHECK(std::abs(std::ranges::count(chosen, v) - 10'000) < 4 * 93);
}

TEST_CASE("The interval of three values is that of all 27 resamples") {
  // Symmetric values: no bias and no acceleration, so BCa takes the 2.5th and 97.5th percentile. The exact
  // distribution has 1/27 = 3.7 % at each end, the extreme values.
  Bootstrap bootstrap;
  const std::vector<double> values{1, 2, 3};
  const auto i = bootstrap.ofMean(values);
  REQUIRE(i);
  CHECK(i->low == 1);
  CHECK(i->high == 3);
  // At 80 % the tails of 10 % lie in the second step, 4/27 = 14.8 %: (1 + 1 + 2)/3.
  const auto inner = bootstrap.ofMean(values, 0.8);
  CHECK(inner->low == Approx(4. / 3));
  CHECK(inner->high == Approx(8. / 3));
}

TEST_CASE("Skewed values move both ends of the interval to their long side") {
  Bootstrap bootstrap;
  const std::vector<double> values{1, 1.1, 1.2, 1.1, 1, 1.3, 1.2, 5};
  std::vector<double> mirrored;
  for (const double x : values) mirrored.push_back(-x);
  const auto i = bootstrap.ofMean(values), m = bootstrap.ofMean(mirrored);
  CHECK(i->high - mean(values) > 1.5 * (mean(values) - i->low));
  // The same resamples, so the mirror image to within what lies between two neighbouring resamples
  CHECK(m->low == Approx(-i->high).epsilon(1e-3));
  CHECK(m->high == Approx(-i->low).epsilon(1e-3));
}

TEST_CASE("Of 10 normal values the 95 % interval holds the mean in about 90 %, of 40 in about 94 %") {
  Bootstrap bootstrap;
  for (const auto& [n, least, most] : {std::tuple(10, 0.87, 0.935), std::tuple(40, 0.92, 0.965)}) {
    int held = 0;
    for (std::uint64_t turn = 0; turn < 1000; ++turn) {
      std::vector<double> values;
      for (int i = 0; i < n; ++i)
        values.push_back(randomNormal({.seed = turn, .cell = {}, .cycle = std::uint32_t(n)}, i));
      const auto interval = bootstrap.ofMean(values);
      held += interval->low <= 0 && 0 <= interval->high;
    }
    INFO(n << " values: " << held);
    CHECK(held / 1000. > least);
    CHECK(held / 1000. < most);
  }
}

TEST_CASE("What does not vary has an interval without width, and one value has none") {
  Bootstrap bootstrap;
  const std::vector<double> same(5, 0.1);
  CHECK(bootstrap.ofMean(same)->low == 0.1);
  CHECK(bootstrap.ofMean(same)->high == 0.1);
  CHECK(variance(same) == 0);
  CHECK(!bootstrap.ofMean(std::span(same).first(1)));
  CHECK(!bootstrap.ofMean({}));
}

TEST_CASE("Many values have Student's interval, which the bootstrap's has come to by then") {
  std::vector<double> values;
  for (std::uint32_t i = 0; i < Bootstrap::many; ++i) values.push_back(randomNormal({8, {}}, i));
  Bootstrap bootstrap;
  const auto student = bootstrap.ofMean(values);
  const auto resampled = bootstrap.ofMean(std::span(values).first(values.size() - 1));
  CHECK(resampled->low == Approx(student->low).margin(0.02 * student->width()));
  CHECK(resampled->high == Approx(student->high).margin(0.02 * student->width()));
}
