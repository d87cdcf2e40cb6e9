#include "base/maths.h"

#include <cmath>
#include <limits>

#include "base/random.h"
#include "catch.h"
#include "worst.h"

using namespace morula;

namespace {

// Distance from the true root in units of the last place of the result.
double errorOfCubeRoot(double a) {
  const double root = cubeRoot(a);
  const long double truth = std::cbrt(static_cast<long double>(a));
  const double place = std::nextafter(root, std::numeric_limits<double>::infinity()) - root;
  return static_cast<double>(std::abs(root - truth) / place);
}

}  // namespace

TEST_CASE("The cube root is right to one unit in the last place, over all normal numbers") {
  double worst = 0;
  for (int exponent = -1022; exponent <= 1023; ++exponent)
    for (int i = 0; i < 50; ++i) {
      const double mantissa = 1 + randomUnit({1, {}, static_cast<std::uint32_t>(exponent + 2000), Purpose::test}, i);
      const double a = std::ldexp(mantissa, exponent);
      CAPTURE(a);
      const double error = errorOfCubeRoot(a);
      if (!(error <= 1)) FAIL("cubeRoot(" << a << ") is off by " << error);
      worst = std::max(worst, error);
    }
  CHECK(worst > 0);
}

TEST_CASE("The cube root at the ends of the range and beside powers of two") {
  const double max = std::numeric_limits<double>::max(), min = std::numeric_limits<double>::min();
  for (double a : {max, min, 1e-300, 1e300, 1e-100, 1e100, std::nextafter(min, 1.0), std::nextafter(max, 1.0)})
    CHECK(errorOfCubeRoot(a) <= 1);
  for (int exponent = -1021; exponent <= 1023; ++exponent) {
    const double a = std::ldexp(1.0, exponent);
    REQUIRE(errorOfCubeRoot(a) <= 1);
    REQUIRE(errorOfCubeRoot(std::nextafter(a, 0.0)) <= 1);
    REQUIRE(errorOfCubeRoot(std::nextafter(a, max)) <= 1);
  }
}

TEST_CASE("The cube root of a small cube is exact") {
  for (int n = 1; n <= 1000; ++n) REQUIRE(cubeRoot(static_cast<double>(n) * n * n) == n);
  for (int exponent = -340; exponent <= 341; ++exponent)
    REQUIRE(cubeRoot(std::ldexp(1.0, 3 * exponent)) == std::ldexp(1.0, exponent));
}

TEST_CASE("The power of two below a number") {
  CHECK(powerOfTwoBelow(1) == 1);
  CHECK(powerOfTwoBelow(std::nextafter(1.0, 0.0)) == 0.5);
  CHECK(powerOfTwoBelow(std::nextafter(2.0, 0.0)) == 1);
  CHECK(powerOfTwoBelow(0.1) == 0.0625);
  CHECK(powerOfTwoBelow(1000) == 512);
  CHECK(powerOfTwoBelow(std::numeric_limits<double>::min()) == std::numeric_limits<double>::min());
  CHECK(powerOfTwoBelow(std::numeric_limits<double>::max()) == 0x1p1023);
  for (int exponent = -1022; exponent <= 1023; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    REQUIRE(powerOfTwoBelow(power) == power);
    REQUIRE(powerOfTwoBelow(power * 1.75) == power);
  }
}

TEST_CASE("The natural logarithm, over all numbers above 0") {
  Worst worst;
  for (int exponent = -1074; exponent <= 1023; ++exponent)
    for (int i = 0; i < 20; ++i) {
      const double mantissa = 1 + randomUnit({2, {}, static_cast<std::uint32_t>(exponent + 2000), Purpose::test}, i);
      const double a = std::ldexp(mantissa, exponent);
      const long double truth = std::log(static_cast<long double>(a));
      worst.see(static_cast<double>(std::abs(naturalLog(a) - truth) / (1 + std::abs(truth))));
    }
  CHECK(worst < 4e-16);
  CHECK(worst > 0);
  CHECK(naturalLog(1) == 0);
  for (const double near : {1 - 0x1p-53, 1 + 0x1p-52, 0.7071067811865475, 0.7071067811865476, 1.414213562373095})
    CHECK(naturalLog(near) == Approx(std::log(near)).epsilon(1e-14));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(naturalLog(0) == -infinity);
  CHECK(naturalLog(infinity) == infinity);
  CHECK(std::isnan(naturalLog(-1)));
  CHECK(std::isnan(naturalLog(std::nan(""))));
}

TEST_CASE("The exponential function, over its whole range") {
  Worst worst;
  const auto compare = [&](double a) {
    const long double truth = std::exp(static_cast<long double>(a));
    worst.see(static_cast<double>(std::abs(exponential(a) - truth) / truth));
  };
  for (std::uint32_t i = 0; i < 200'000; ++i) compare(-708 + 1417 * randomUnit({3, {}, 0, Purpose::test}, i));
  for (std::uint32_t i = 0; i < 50'000; ++i) compare(2 * randomUnit({4, {}, 0, Purpose::test}, i) - 1);
  CHECK(worst < 3e-16);
  CHECK(worst > 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(exponential(0) == 1);
  CHECK(exponential(-0.0) == 1);
  CHECK(exponential(0x1p-60) == 1);
  CHECK(exponential(709.78) == Approx(std::exp(709.78)).epsilon(1e-15));
  CHECK(exponential(709.8) == infinity);
  CHECK(exponential(infinity) == infinity);
  for (double a = -708.5; a > -745; a -= 0.37)  // subnormal results have fewer digits
    REQUIRE(std::abs(exponential(a) - std::exp(a)) <= 2 * std::numeric_limits<double>::denorm_min());
  CHECK(exponential(-746) == 0);
  CHECK(exponential(-infinity) == 0);
  CHECK(std::isnan(exponential(std::nan(""))));
}

TEST_CASE("Sine and cosine, in all four quarters and beside their zeros") {
  Worst worst;
  const auto compare = [&](double angle) {
    const auto [sine, cosine] = sineAndCosine(angle);
    const auto exact = static_cast<long double>(angle);
    worst.see(static_cast<double>(std::abs((sine - std::sin(exact)) / std::sin(exact))));
    worst.see(static_cast<double>(std::abs((cosine - std::cos(exact)) / std::cos(exact))));
  };
  for (const double range : {1.0, 7.0, 1000.0, 1e5})
    for (int i = 0; i < 50'000; ++i) {
      const double u = randomUnit({5, {}, 0, Purpose::test}, static_cast<std::uint32_t>(i));
      compare(range * (2 * u - 1));
    }
  for (int quarter = -1000; quarter <= 1000; ++quarter)
    if (quarter != 0) compare(quarter * 1.5707963267948966);
  CHECK(worst < 5e-16);
  CHECK(worst > 0);
  CHECK(sineAndCosine(0).sine == 0);
  CHECK(sineAndCosine(0).cosine == 1);
  CHECK(sineAndCosine(1e-300).sine == 1e-300);
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1e10})
    CHECK((std::isnan(sineAndCosine(bad).sine) && std::isnan(sineAndCosine(bad).cosine)));
}
