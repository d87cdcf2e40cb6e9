// Ticks of an axis: their places, and which of them have numbers.
#include "drawing/axis.h"

#include <cmath>

#include "catch.h"

namespace morula {

using Numbers = std::vector<double>;

TEST_CASE("the ticks of a linear axis are round, evenly spaced and inside", "[axis]") {
  const auto linear = [](double low, double high, int wanted) { return Axis{.low = low, .high = high}.ticks(wanted); };
  REQUIRE(linear(0, 6, 6) == Numbers{0, 1, 2, 3, 4, 5, 6});
  for (const double low : {0.0, -3.7, 0.013})
    for (const double span : {0.02, 1.0, 7.3, 128.0, 99999.0})
      for (const int wanted : {2, 5, 10}) {
        const Numbers ticks = linear(low, low + span, wanted);
        REQUIRE(ticks.size() <= std::size_t(wanted) + 1);
        REQUIRE(double(ticks.size()) >= wanted / 2.5 - 1);
        REQUIRE(ticks.front() >= low - 1e-9 * span);
        REQUIRE(ticks.back() <= low + span * (1 + 1e-9));
        if (ticks.size() < 2) continue;
        const double step = ticks[1] - ticks[0];
        const double mantissa = step / std::pow(10.0, std::floor(std::log10(step * (1 + 1e-9))));
        REQUIRE((std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 5) < 1e-6));
      }
  REQUIRE(linear(2, 2, 5) == Numbers{2});
}

TEST_CASE("decades are written with 2 and 5, or alone where there are many", "[axis]") {
  const auto decades = [](double low, double high) {
    return Axis{.scale = Axis::Scale::decades, .low = low, .high = high}.ticks();
  };
  CHECK(decades(0.8, 60) == Numbers{1, 2, 5, 10, 20, 50});
  CHECK(decades(1, 10) == Numbers{1, 2, 5, 10});
  const Numbers many = decades(2e-18, 3e-3);
  REQUIRE(many.size() == 15);
  CHECK(many.front() == Approx(1e-17));
  CHECK(many.back() == Approx(1e-3));
  CHECK((Axis{.scale = Axis::Scale::powersOfTwo, .low = 3, .high = 64}.ticks() == Numbers{4, 8, 16, 32, 64}));
}

TEST_CASE("places: ends at the ends, and the middle by the scale", "[axis]") {
  for (const auto scale : {Axis::Scale::linear, Axis::Scale::decades, Axis::Scale::powersOfTwo}) {
    const Axis axis{.scale = scale, .low = 1, .high = 100, .from = 300, .to = 100};
    CHECK(axis.place(1) == 300);
    CHECK(axis.place(100) == 100);
    CHECK(axis.place(scale == Axis::Scale::linear ? 50.5 : 10) == Approx(200));
  }
  CHECK(Axis{.low = 3, .high = 3, .from = 7}.place(3) == 7);
}

TEST_CASE("an axis of a share ends at 0 and 1, unless its values lie beyond", "[axis]") {
  const AxisBounds share{0, 1};
  const auto ends = [&](double low, double high) {
    const Range range = share.around({low, high}, 0.1);
    return std::pair{range.low, range.high};
  };
  CHECK(ends(0.05, 1) == std::pair{0.0, 1.0});
  CHECK(ends(0.3, 0.6) == std::pair{0.3 - 0.1, 0.6 + 0.1});
  CHECK(ends(0, 1.25) == std::pair{0.0, 1.25});
  CHECK(AxisBounds{}.around({0, 1}, 0.5).high == 1.5);
  CHECK(share.clamped(-0.2) == 0);
  CHECK(share.clamped(1.2) == 1);
}

TEST_CASE("a range is what was seen", "[axis]") {
  Range range;
  for (const double a : {3.0, -2.0, 1.0}) range.see(a);
  CHECK(range.low == -2);
  CHECK(range.high == 3);
}

}  // namespace morula
