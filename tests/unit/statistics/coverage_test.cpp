// The coverage that is said of intervals of means, counted in samples of known distributions, and how intervals tell
// skewed values and groups.
#include "statistics/coverage.h"

#include <array>
#include <cmath>
#include <functional>

#include "catch.h"
#include "numbers.h"
#include "statistics/means.h"
#include "statistics/sign_flip.h"

using namespace morula;
using namespace morula::test;

namespace {

struct Distribution {
  const char* name;
  std::function<double(Numbers&)> draw;
  double mean;
  double Coverage::*said;  // what the table says of it
};

const std::array<Distribution, 4> distributions{{
    {"normal", [](Numbers& r) { return r.farNormal(); }, 0, &Coverage::normal},
    {"exponential", [](Numbers& r) { return r.exponential(); }, 1, &Coverage::exponential},
    {"log-normal", [](Numbers& r) { return std::exp(r.farNormal()); }, std::exp(0.5), &Coverage::logNormal},
    {"one in ten", [](Numbers& r) { return (r.unit() < 0.1) + 0.02 * r.farNormal(); }, 0.1, &Coverage::oneInTen},
}};

MeanEstimate estimateOf(const std::vector<double>& values, bool isDifference) {
  const double n = double(values.size());
  return {mean(values), std::sqrt(variance(values) / n), n - 1, values.size(), shapeOf(values), isDifference};
}

/// How many of many samples have a shape that is told, and how many intervals hold the mean.
struct Counts {
  int all = 0, held = 0, told = 0, toldAndHeld = 0;

  Counts(const Distribution& of, std::size_t n, bool isDifference) {
    for (std::uint64_t s = 0; s < studies; ++s) {
      Numbers numbers(21'000'000 + 10'000 * n + s);
      const auto values = sample(n, [&] { return of.draw(numbers); });
      const Interval interval = intervalOf(estimateOf(values, isDifference), 0.95);
      const bool holds = interval.low <= of.mean && of.mean <= interval.high;
      const bool isTold = shapeOf(values).shape != SampleShape::plain;
      ++all, held += holds, told += isTold, toldAndHeld += isTold && holds;
    }
  }
};

/// Checks that a p-value is the one at which the interval ends.
void checkDual(const MeanEstimate& e) {
  for (const double level : {0.5, 0.9, 0.95, 0.99}) {
    const Interval i = intervalOf(e, level);
    CHECK(chanceAbove(e, i.low) == Approx(0.5 - 0.5 * level).margin(1e-6));
    CHECK(chanceBelow(e, i.high) == Approx(0.5 - 0.5 * level).margin(1e-6));
    CHECK(i.low < e.mean);
    CHECK(e.mean < i.high);
  }
}

}  // namespace

TEST_CASE("An interval holds the mean in 93 % of samples and more, or is said to hold it less") {
  for (const Distribution& of : distributions)
    for (const std::size_t n : {2, 3, 5, 10, 20, 50})
      for (const bool isDifference : {false, true}) {
        if (isDifference && of.said != &Coverage::oneInTen) continue;  // only groups are treated otherwise
        const Counts counts(of, n, isDifference);
        const double held = 100. * counts.held / counts.all, said = (*coverageOf(n)).*of.said;
        INFO(of.name << ", " << n << " values" << (isDifference ? ", differences: " : ": ") << held << " %, told "
                     << counts.told << ", of these held " << counts.toldAndHeld);
        CHECK(held == Approx(said).margin(1.5));
        // A sample of five without the rare outcome may be told by chance, and does not hold the mean.
        if (n >= 5 && n <= 20) CHECK(counts.toldAndHeld >= 0.92 * counts.told);
      }
}

TEST_CASE("An interval of an outcome that one run in ten has holds its share, unless no run has it") {
  for (const std::size_t n : {3, 5, 10, 20}) {
    int held = 0, given = 0;
    for (std::uint64_t s = 0; s < studies; ++s) {
      Numbers numbers(23'000'000 + 10'000 * n + s);
      const auto interval = intervalOfMean(sample(n, [&] { return numbers.unit() < 0.1 ? 3. : 2.; }));
      if (!interval) continue;
      ++given, held += interval->low <= 2.1 && 2.1 <= interval->high;
      CHECK(interval->low >= 2);
      CHECK(interval->high <= 3);
    }
    INFO(n << ": " << given << " intervals, of which " << held << " hold the mean");
    CHECK(given > 0.2 * studies);
    CHECK(held >= 0.95 * given);
  }
}

TEST_CASE("The coverage said is that of the largest tabled number that is not above the number of values") {
  CHECK(!coverageOf(0));
  CHECK(!coverageOf(1));
  CHECK(coverageOf(2)->n == 2);
  CHECK(coverageOf(9)->n == 5);
  CHECK(coverageOf(10)->n == 10);
  CHECK(coverageOf(1000)->n == 50);
}

TEST_CASE("Skewed samples and samples of two groups are told, those of normal values in 7 of 100 at most") {
  CHECK(shapeOf(std::vector<double>{1, 2, 3, 4, 20}).shape == SampleShape::skewed);
  CHECK(shapeOf(std::vector<double>{-1, -2, -3, -4, -20}).skewness ==
        Approx(-shapeOf(std::vector<double>{1, 2, 3, 4, 20}).skewness));
  CHECK(shapeOf(std::vector<double>{1, 2, 3, 4, 5}).shape == SampleShape::plain);
  const auto two = shapeOf(std::vector<double>{1.01, 2, 0.99, 1, 2.01, 1.02});
  CHECK(two.shape == SampleShape::twoGroups);
  CHECK(two.groups.low == Approx(1.005));
  CHECK(two.groups.countHigh == 2);
  CHECK(!two.groups.repeats);
  CHECK(shapeOf(std::vector<double>{0, 1, 0}).groups.repeats);
  CHECK(shapeOf(std::vector<double>{0, 1}).shape == SampleShape::plain);
  CHECK(shapeOf(std::vector<double>(10, 0.1)).shape == SampleShape::plain);
  CHECK(shapeOf(std::vector<double>{0.3, 0.1 + 0.2, 0.3, 0.3, 0.3}).shape == SampleShape::plain);  // but for rounding
  for (const std::size_t n : {5, 6, 7, 8, 10, 20}) {
    int told = 0;
    for (std::uint64_t s = 0; s < studies; ++s) {
      Numbers numbers(25'000'000 + 10'000 * n + s);
      told += shapeOf(sample(n, [&] { return numbers.farNormal(); })).shape != SampleShape::plain;
    }
    INFO(n << ": " << told);
    CHECK(told <= 0.07 * studies);
    CHECK(told >= 0.04 * studies);
  }
}

TEST_CASE("p-values and intervals agree, whatever the shape of the sample") {
  for (const bool isDifference : {false, true}) {
    checkDual(estimateOf({1, 2, 3, 4, 5}, isDifference));
    checkDual(estimateOf({1, 2, 3, 4, 20}, isDifference));
    checkDual(estimateOf({-1, -2, -3, -4, -20}, isDifference));
    checkDual(estimateOf({2, 2, 2, 3, 2, 3}, isDifference));
    checkDual(estimateOf({0, 0, 0, 1, 0, 1}, isDifference));
    checkDual(estimateOf({0, 0, 0, -1, 0, -1}, isDifference));
    checkDual(estimateOf({1.01, 2, 0.99, 1, 2.01, 1.02}, isDifference));
  }
}

TEST_CASE("The interval of a skewed sample is Student's, with the end on the side of the tail moved out") {
  const auto e = estimateOf({1, 2, 3, 4, 20}, false);
  const Interval plain = studentInterval(e, 0.95), skewed = intervalOf(e, 0.95);
  CHECK(skewed.low == plain.low);
  const double q = (plain.high - e.mean) / e.standardError;
  CHECK((skewed.high - e.mean) / e.standardError ==
        Approx(q + e.sample.skewness * (1 + 2 * q * q) / (6 * std::sqrt(5.))));
}

TEST_CASE("Differences of which most are 0 have an interval that allows for opposite ones") {
  // Four of ten pairs differ, all in one direction: p = 2/16, and 0 lies in the interval.
  const std::vector<double> some{0, 0, 1, 0, 1, 0, 1, 0, 1, 0}, none(10, 0.);
  const auto few = comparePaired(some, none);
  CHECK(few.p == signFlipP(some));
  CHECK(few.interval->low < 0);
  CHECK(few.interval->high == Approx(intervalOfShare(4, 10, 0.95).high));
  // The values of a condition are shares of runs.
  CHECK(intervalOfMean(some)->low == Approx(intervalOfShare(4, 10, 0.95).low));
  CHECK(intervalOfShare(0, 10, 0.95).high == Approx(1 - std::pow(0.025, 0.1)));
  CHECK(intervalOfShare(0, 10, 0.95).low == 0);
  CHECK(intervalOfShare(10, 10, 0.95).high == 1);
  CHECK(intervalOfShare(4, 10, 0.95).low == Approx(0.12155).margin(1e-5));  // [Clopper & Pearson 1934]
  CHECK(intervalOfShare(4, 10, 0.95).high == Approx(0.73762).margin(1e-5));
}
