// Random tilts of axes, keyed by a seed.
#include "division/tilt.h"

#include <numbers>

#include "catch.h"

using namespace morula;

namespace {

constexpr int draws = 20'000;

Draw drawOf(int i) {
  CellPath path;
  for (int bit = 0; bit < 16; ++bit) path = path.daughter(i >> bit & 1);
  return {11, path, 0, Purpose::tilt};
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE("Tilted axes have unit length and the mean cosine of von Mises and Fisher") {
  for (const double sd : {0.001, 1.0, 10.0, 30.0, 60.0, 90.0}) {
    CAPTURE(sd);
    const Vector axis{0.36, -0.48, 0.8};
    Vector sum{};
    double square = 0, farthest = 0;
    for (int i = 0; i < draws; ++i) {
      const Vector tilted = tiltAxis(axis, sd, drawOf(i));
      REQUIRE(norm(tilted) == Approx(1).epsilon(1e-14));
      sum += tilted;
      const Vector off = tilted - dot(tilted, axis) * axis;
      square += dot(off, off);
      farthest = std::max(farthest, norm(tilted - axis));
    }
    const double radians = sd * std::numbers::pi / 180, kappa = 1 / (radians * radians);
    const double expected = 1 / std::tanh(kappa) - 1 / kappa;  // mean resultant length
    CHECK(dot(sum, axis) / draws == Approx(expected).margin(4 / std::sqrt(draws * kappa)));
    CHECK(norm(sum) / draws == Approx(expected).margin(4 / std::sqrt(draws * kappa)));
    // Along each tangent a small tilt is normal with the given standard deviation.
    if (sd <= 10) CHECK(degrees(std::sqrt(square / draws / 2)) == Approx(sd).epsilon(0.03));
    CHECK(farthest > radians);
  }
}

TEST_CASE("A tilt looks to no side") {
  const Vector axis{0, 0.6, 0.8}, side{1, 0, 0}, other{0, 0.8, -0.6};
  int quarters[4] = {};
  for (int i = 0; i < draws; ++i) {
    const Vector tilted = tiltAxis(axis, 20, drawOf(i));
    ++quarters[(dot(tilted, side) > 0) + 2 * (dot(tilted, other) > 0)];
  }
  for (const int count : quarters) CHECK(std::abs(count - draws / 4) < 4 * std::sqrt(draws * 3 / 16.0));
}

TEST_CASE("The angle of a tilt belongs to the draw, whatever the axis") {
  const std::vector<Vector> axes{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},      {0, 0, 1},
                                 {0, 0, -1}, {0, -1, 0}, {0.6, 0, -0.8}, {0.36, 0.48, -0.8}};
  for (int i = 0; i < 50; ++i) {
    const double cosine = dot(tiltAxis(axes[0], 15, drawOf(i)), axes[0]);
    for (const Vector& axis : axes) CHECK(dot(tiltAxis(axis, 15, drawOf(i)), axis) == Approx(cosine).epsilon(1e-14));
  }
  CHECK_FALSE(tiltAxis(axes[0], 15, drawOf(1)) == tiltAxis(axes[0], 15, drawOf(2)));
}

TEST_CASE("Neighbouring axes are tilted alike") {
  for (int i = 0; i < 50; ++i) {
    const Vector a = tiltAxis({0, 0.6, 0.8}, 15, drawOf(i));
    const Vector near{1e-6, 0.6, 0.8};
    CHECK(norm(tiltAxis(near / norm(near), 15, drawOf(i)) - a) < 3e-6);
  }
}
