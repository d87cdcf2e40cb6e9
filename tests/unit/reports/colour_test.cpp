#include "image/colour.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "catch.h"

namespace morula {

TEST_CASE("a colour is read as it is written", "[colour]") {
  REQUIRE(parseColour("#e41a1c") == Colour{0xe4, 0x1a, 0x1c});
  REQUIRE(parseColour("#E41A1C") == Colour{0xe4, 0x1a, 0x1c});
  for (int i = 0; i < 256; ++i) {
    const Colour c{std::uint8_t(i), std::uint8_t(255 - i), std::uint8_t(i * 7)};
    REQUIRE(parseColour(fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b)) == c);
  }
}

TEST_CASE("what is not a colour is refused, and the text says what would be", "[colour]") {
  for (const char* wrong : {"", "red", "e41a1c", "#e41a1", "#e41a1c0", "#e41a1g", " #e41a1c", "#-41a1c"})
    REQUIRE_THROWS_AS(parseColour(wrong), InputError);
  REQUIRE_THROWS_WITH(parseColour("red"), ContainsSubstring("'red'") && ContainsSubstring("#rrggbb"));
}

TEST_CASE("linear light follows the sRGB curve and comes back exactly", "[colour]") {
  REQUIRE(linearLight(0) == 0);
  REQUIRE(linearLight(255) == Approx(1));
  REQUIRE(linearLight(188) == Approx(0.5029).margin(1e-4));  // the well-known mid grey of monitors
  for (int i = 0; i < 256; ++i) REQUIRE(channelOf(linearLight(std::uint8_t(i))) == i);
  REQUIRE(channelOf(-1) == 0);
  REQUIRE(channelOf(2) == 255);
}

TEST_CASE("mixing is the mean in linear light", "[colour]") {
  REQUIRE(mixColours({}) == neutralGrey);
  REQUIRE(mixColours({{1, 2, 3}}) == Colour{1, 2, 3});
  REQUIRE(mixColours({{9, 99, 200}, {9, 99, 200}}) == Colour{9, 99, 200});
  // Half of full light is channel 188, not 128, which would look too dark.
  REQUIRE(mixColours({{255, 0, 0}, {0, 255, 0}}) == Colour{188, 188, 0});
  const double third = (linearLight(10) + linearLight(200) + linearLight(90)) / 3;
  REQUIRE(mixColours({{10, 0, 0}, {200, 0, 0}, {90, 0, 0}}).r == channelOf(third));
}

TEST_CASE("the order of mixed colours does not matter", "[colour]") {
  std::vector<Colour> colours{{228, 26, 28}, {55, 126, 184}, {77, 175, 74}, {255, 127, 0}, {3, 3, 3}};
  const auto less = [](Colour a, Colour b) { return a.r < b.r; };
  std::sort(colours.begin(), colours.end(), less);
  const Colour mixed = mixColours(colours);
  do REQUIRE(mixColours(colours) == mixed);
  while (std::next_permutation(colours.begin(), colours.end(), less));
}

}  // namespace morula
