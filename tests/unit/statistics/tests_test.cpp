// Tests and effect sizes: worked examples, symmetries, and samples without variation.
#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "statistics/distributions.h"
#include "statistics/equivalence.h"
#include "statistics/factorial.h"
#include "statistics/means.h"

using namespace morula;

namespace {

// Extra hours of sleep under two drugs, ten patients [Student 1908].
const std::vector<double> first{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const std::vector<double> second{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

/// Returns 3 × 2 cells of n values: main effects, an interaction, and noise, part of which a replicate's cells share.
std::vector<double> designed(double interaction, double noise, double shared, std::size_t n = 6) {
  std::vector<double> values;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 2; ++b)
      for (std::uint32_t r = 0; r < n; ++r)
        values.push_back(2. * a + 5. * b + interaction * (a == 2 && b == 1) + shared * randomNormal({1, {}}, r) +
                         noise * randomNormal({2 + std::uint64_t(2 * a + b), {}}, r));
  return values;
}

const std::vector<std::size_t> threeByTwo{3, 2};

}  // namespace

TEST_CASE("Student's own example: pairs show what two samples do not") {
  const auto paired = comparePaired(second, first);
  CHECK(paired.difference == Approx(1.58));
  CHECK(paired.t == Approx(4.0621).epsilon(1e-4));
  CHECK(studentBeyond(paired.t, 9) == Approx(0.002833).epsilon(1e-3));
  CHECK(paired.p == 2. / 512);  // hours to one decimal repeat, so the exact test counts: 2 of 512 choices of signs
  // A tenth patient slept 4.6 hours longer, far more than the others: the interval reaches farther up than Student's.
  CHECK(paired.sample.shape == SampleShape::skewed);
  CHECK(paired.interval->low == Approx(0.7001142).epsilon(1e-6));
  CHECK(studentInterval(paired.estimate(), 0.95).high == Approx(2.4598858).epsilon(1e-6));
  CHECK(paired.interval->high > 2.8);
  const auto unpaired = compareUnpaired(second, first);
  CHECK(unpaired.difference == Approx(1.58));
  CHECK(unpaired.degreesOfFreedom == Approx(17.776).epsilon(1e-4));
  CHECK(unpaired.p == Approx(0.07939).epsilon(1e-3));
  CHECK(unpaired.interval->width() > 2 * studentInterval(paired.estimate(), 0.95).width());
  const auto signs = signsOf(second, first);
  CHECK(signs.higher == 9);
  CHECK(signs.same == 1);
  CHECK(effectSizes(second, first).dz == Approx(4.0621 / std::sqrt(10)).epsilon(1e-4));
}

TEST_CASE("Where the difference does not vary it is as sure as an exact test of its signs, and has no interval") {
  const std::vector<double> a{0.1, 0.2, 0.7}, b{1.1, 1.2, 1.7};
  const std::vector<double> one(3, 0.1), two(3, 0.2);
  const auto certain = comparePaired(one, two);
  CHECK(certain.p == 0.25);  // 2^(1 − 3)
  CHECK(std::isinf(certain.t));
  CHECK(certain.t < 0);
  CHECK(comparePaired(two, one).t > 0);  // the sign follows the difference, however small
  CHECK(!certain.interval);
  CHECK(comparePaired(std::vector<double>(10, 4.), std::vector<double>(10, 5.)).p == std::ldexp(1, -9));
  const auto same = comparePaired(a, a);
  CHECK(same.p == 1);
  CHECK(same.t == 0);
  CHECK(!effectSizes(a, a).dz);
  CHECK(effectSizes(a, a).d == 0.);
  CHECK(!effectSizes(one, two).d);
  CHECK(!effectSizes(one, two).g);
  CHECK(compareUnpaired(one, one).p == 1);
  CHECK(compareUnpaired(one, two).p == Approx(0.1));  // two of the 20 ways to deal out six values
  CHECK(signsOf(a, b).lower == 3);
}

TEST_CASE("Hedges' factor is the closed form of few and tends to 1 − 3/(4 df − 1)") {
  CHECK(hedgesFactor(2) == Approx(1 / std::sqrt(M_PI)));                         // Γ(1)/(1 · Γ(½))
  CHECK(hedgesFactor(4) == Approx(1 / std::sqrt(2) / (0.5 * std::sqrt(M_PI))));  // Γ(2)/(√2 Γ(3/2))
  CHECK(hedgesFactor(1000) == Approx(1 - 3. / 3999).epsilon(1e-6));
  // Three pairs have 2 · (3 − 1) = 4 degrees of freedom. Means are 2 and 5; variances 1 and 4 have the mean 5/2.
  const auto sizes = effectSizes(std::vector<double>{1, 2, 3}, std::vector<double>{3, 7, 5});
  CHECK(*sizes.d == Approx(-3 / std::sqrt(2.5)));
  CHECK(*sizes.g == Approx(*sizes.d * std::sqrt(2 / M_PI)));  // hedgesFactor(4)
}

TEST_CASE("Equivalent is what the margin holds, different what lies beyond it, and the rest is not decided") {
  const auto verdict = [](const MeanDifference& d, double margin) {
    const auto e = testEquivalence(d, margin);
    return std::string(nameOf(verdictOf(e.p, e.pBeyond)));
  };
  const auto sleep = comparePaired(second, first);  // mean 1.58, 90 % interval 0.87 to 2.5: Student's 2.29
  CHECK(verdict(sleep, 0.5) == "different");
  CHECK(verdict(sleep, 1.5) == "not decided");
  CHECK(verdict(sleep, 2) == "not decided");
  CHECK(verdict(sleep, 2.4) == "not decided");
  CHECK(verdict(sleep, 2.7) == "equivalent");
  CHECK(verdict(comparePaired(first, second), 2.7) == "equivalent");
  CHECK(verdict(comparePaired(first, second), 0.5) == "different");
  for (const double margin : {0.3, 0.87, 1.3, 2.29, 2.4, 2.7}) {  // tests and interval agree
    const auto e = testEquivalence(sleep, margin);
    CHECK((e.p < 0.05) == (e.interval->low > -margin && e.interval->high < margin));
  }
  const std::vector<double> one(3, 0.25), two(3, 0.5);
  CHECK(verdict(comparePaired(one, two), 0.3) == "not decided");  // three pairs may be alike by chance
  CHECK(verdict(comparePaired(one, two), 0.2) == "not decided");
  const std::vector<double> ones(10, 0.25), twos(10, 0.5);
  CHECK(verdict(comparePaired(ones, twos), 0.3) == "equivalent");
  CHECK(verdict(comparePaired(ones, twos), 0.2) == "different");
  CHECK(verdict(comparePaired(ones, ones), 1e-12) == "equivalent");
  const MeanDifference exact{.difference = -0.25};  // one run each, as seeds change nothing
  CHECK(verdict(exact, 0.3) == "equivalent");
  CHECK(verdict(exact, 0.2) == "different");
}

TEST_CASE("Holm's correction is the worked one") {
  CHECK(correctHolm({}).empty());
  const std::vector<double> p{0.01, 0.04, 0.03, 0.005};  // in order: 0.005·4, 0.01·3, 0.03·2, 0.04·1 → 0.06
  const auto corrected = correctHolm(p);
  CHECK(corrected[3] == Approx(0.02));
  CHECK(corrected[0] == Approx(0.03));
  CHECK(corrected[2] == Approx(0.06));
  CHECK(corrected[1] == Approx(0.06));
  CHECK(correctHolm(std::vector<double>{0.9, 0.8}) == std::vector<double>{1, 1});
}

TEST_CASE("Effects that add up have no interaction, and shares of all effects sum to one without noise") {
  const auto analysis = analyseFactorial(threeByTwo, designed(0, 0, 0));
  REQUIRE(analysis.effects.size() == 3);
  // Expected: Σ (2a − 2)² over 12 values each = 12 · 8, and 36 · 2.5².
  CHECK(analysis.effects[0].squares == Approx(96));
  CHECK(analysis.effects[1].squares == Approx(225));
  CHECK(analysis.effects[2].squares == Approx(0).margin(1e-12));
  CHECK(analysis.effects[0].share + analysis.effects[1].share == Approx(1));
  CHECK(!analysis.effects[0].f);  // cells do not vary: there is no error to test against
  CHECK(levelMeans(threeByTwo, designed(0, 0, 0), 0) == std::vector<double>{2.5, 4.5, 6.5});
  CHECK(levelMeans(threeByTwo, designed(0, 0, 0), 1) == std::vector<double>{2, 7});
}

TEST_CASE("With the errors of all effects and what seeds have in common, sums of squares add up to the whole one") {
  const auto values = designed(1.5, 0.3, 0.8);
  const auto analysis = analyseFactorial(threeByTwo, values);
  double sum = 0;
  for (const FactorEffect& e : analysis.effects) sum += e.squares + e.errorSquares;
  std::vector<double> seeds(6);
  for (std::size_t i = 0; i < values.size(); ++i) seeds[i % 6] += values[i] / 6;
  sum += 6 * 5 * variance(seeds);
  CHECK(sum == Approx(analysis.squares));
}

TEST_CASE("What a seed has in common in all cells is no error where seeds are blocks") {
  const auto quiet = analyseFactorial(threeByTwo, designed(1.5, 0.3, 0));
  const auto loud = analyseFactorial(threeByTwo, designed(1.5, 0.3, 20));
  CHECK(loud.effects[2].p == Approx(*quiet.effects[2].p).epsilon(1e-6));
  CHECK(*loud.effects[2].p < 1e-3);
}

TEST_CASE("Two levels of one factor are a paired t test") {
  std::vector<double> values = first;
  values.insert(values.end(), second.begin(), second.end());
  const std::vector<std::size_t> two{2};
  const auto paired = comparePaired(first, second);
  const auto analysis = analyseFactorial(two, values);
  CHECK(*analysis.effects[0].f == Approx(paired.t * paired.t));
  CHECK(*analysis.effects[0].p == Approx(paired.p));
  CHECK(analysis.effects[0].epsilon == 1);
  // Partial η² follows from t: t²/(t² + df).
  CHECK(*analysis.effects[0].partial == Approx(paired.t * paired.t / (paired.t * paired.t + 9)));
}
