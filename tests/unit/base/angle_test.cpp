// Angles against the standard library's, which may differ between machines in the last bit.
#include "base/angle.h"

#include "catch.h"

using namespace morula;

TEST_CASE("The arc tangent is the library's to within a few ulp") {
  for (int i = 0; i <= 10000; ++i) {
    const double t = i / 10000.0;
    CHECK(std::abs(arcTangent(t) - std::atan(t)) < 6e-16);
  }
  CHECK(arcTangent(0) == 0);
  CHECK(arcTangent(1e-200) == Approx(1e-200).epsilon(1e-15));
}

TEST_CASE("The angle of two lines goes from 0 to 90, whichever way they point, and is exact where it is small") {
  const Vector x{1, 0, 0};
  for (double degrees : {0.0, 1e-7, 0.5, 30.0, 45.0, 60.0, 89.999, 90.0}) {
    const double a = degrees * 0.017453292519943295;
    const Vector u{std::cos(a), std::sin(a), 0};
    CHECK(angleOfLines(x, u) == Approx(degrees).epsilon(1e-12).margin(1e-15));
    CHECK(angleOfLines(u, -x) == Approx(degrees).epsilon(1e-12).margin(1e-15));
  }
}
