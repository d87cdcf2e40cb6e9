// Slopes, Richardson's estimate and interpolation, against closed forms.
#include "accuracy/convergence.h"

#include <cmath>

#include "catch.h"

using namespace morula;

TEST_CASE("A power law is found to the last digits, whatever its exponent") {
  for (double slope : {-2.0, 0.5, 1.0, 4.0}) {
    std::vector<XY> points;
    for (double x : {1e-4, 3e-3, 0.1, 7.0}) points.push_back({x, 5e-3 * std::pow(x, slope)});
    const auto law = fitPowerLaw(points);
    REQUIRE(law);
    CHECK(law->slope == Approx(slope).epsilon(1e-12));
    CHECK(law->slopeError < 1e-12);
    CHECK(law->points == 4);
  }
}

TEST_CASE("The slope's error is the textbook's") {
  // The logarithms x = 0, 1, 2 and y = 0, 3, 3 have the slope 1.5 and residuals −0.5, 1, −0.5, so s² = 1.5/1 and s/√Sxx
  // = √0.75.
  const auto law = fitPowerLaw({{1, 1}, {std::exp(1.0), std::exp(3.0)}, {std::exp(2.0), std::exp(3.0)}});
  REQUIRE(law);
  CHECK(law->slope == Approx(1.5).epsilon(1e-12));
  CHECK(law->slopeError == Approx(std::sqrt(0.75)).epsilon(1e-12));
}

TEST_CASE("What has no logarithm is left out, and one point is no line") {
  CHECK(fitPowerLaw({{1, 2}, {2, 4}, {4, 0}, {8, NAN}, {16, INFINITY}})->points == 2);
  CHECK(fitPowerLaw({{1, 2}, {2, 4}, {4, -1}})->slope == Approx(1).epsilon(1e-12));
  CHECK_FALSE(fitPowerLaw({{1, 2}}));
  CHECK_FALSE(fitPowerLaw({{1, 2}, {1, 3}}));
  CHECK_FALSE(fitPowerLaw({}));
}

TEST_CASE("Richardson's estimate is the error where it is a pure power of the step") {
  for (double p : {1.0, 2.0, 4.0}) {
    const auto at = [&](double h) { return 3 + 0.7 * std::pow(h, p); };
    const LeftError left = estimateByRichardson(at(0.4) - at(0.2), at(0.2) - at(0.1), 4);
    CHECK(left.order == Approx(p).epsilon(1e-9));
    CHECK(left.error == Approx(at(0.1) - 3).epsilon(1e-9));
  }
}

TEST_CASE("An order beyond the method's is not believed, and what does not converge is as bad as it looks") {
  CHECK(estimateByRichardson(1.0, 1.0 / 64, 2).order == 2);
  CHECK(estimateByRichardson(1.0, 1.0 / 64, 2).error == Approx(1.0 / 64 / 3).epsilon(1e-12));
  CHECK(estimateByRichardson(1e-3, 2e-3, 2).error == 2e-3);
  CHECK(estimateByRichardson(1e-3, 1e-3, 2).order == 0);
  CHECK(estimateByRichardson(1e-3, 1e-3, 2).error == 1e-3);
  CHECK(estimateByRichardson(0, 0, 2).error == 0);
  CHECK(estimateByRichardson(INFINITY, INFINITY, 2).error == INFINITY);
  CHECK(estimateByRichardson(NAN, 1, 2).order == 0);
}

TEST_CASE("Cost at an error lies on the straight line in logarithms, and nowhere outside") {
  // Here error = cost^-2.
  const std::vector<WorkPoint> series{{1, 1}, {10, 1e-2}, {100, 1e-4}};
  CHECK(*costAtError(series, 1e-3) == Approx(std::pow(10, 1.5)).epsilon(1e-12));
  CHECK(*costAtError(series, 1e-2) == Approx(10).epsilon(1e-12));
  CHECK(*costAtError(series, 1) == Approx(1).epsilon(1e-12));
  CHECK_FALSE(costAtError(series, 1.01));
  CHECK_FALSE(costAtError(series, 0.99e-4));
  CHECK_FALSE(costAtError({{1, 1}}, 1));
  CHECK_FALSE(costAtError({}, 1));
}

TEST_CASE("Where errors rise again, the cheaper crossing counts; a gap is not bridged") {
  CHECK(*costAtError({{1, 1}, {2, 0.1}, {4, 1}, {8, 0.01}}, 0.5) < 2);
  CHECK_FALSE(costAtError({{1, 1}, {2, 0}, {4, 0.01}}, 0.1));
  CHECK_FALSE(costAtError({{1, 1}, {2, NAN}, {4, 0.01}}, 0.1));
}
