#include "yaml/numbers.h"

#include <cmath>
#include <random>

#include "catch.h"

using namespace morula;
using namespace morula::scenario;

TEST_CASE("plain decimal numbers are read to the last bit") {
  CHECK(parseReal("1").value == 1);
  CHECK(parseReal("-2.5").value == -2.5);
  CHECK(parseReal("+.5").value == 0.5);
  CHECK(parseReal("5.").value == 5);
  CHECK(parseReal("0.1").value == 0.1);
  CHECK(parseReal("1e-3").value == 1e-3);
  CHECK(parseReal("1E+3").value == 1000);
  CHECK(parseReal("0").value == 0);
  CHECK(!std::signbit(parseReal("-0").value));
  CHECK(parseNatural("9223372036854775807").value == 9223372036854775807u);
  CHECK(parseNatural("+7").value == 7);
  for (const auto* text : {"1", "-2.5", "+.5", "5.", "0.1", "1e-3", "1E+3", "0"}) CHECK(parseReal(text).wrong.empty());
}

TEST_CASE("everything else is refused, with the reason") {
  for (const auto* text :
       {"",     "-",     "+",   ".",   "e5",   "one",   "1.0 s", "1s",  "1 2",  "1,5",   "1_000",  "010",
        "-007", "0x10",  "0o7", "0b1", ".inf", "-.Inf", "inf",   "nan", ".NaN", "1e400", "1e-400", "1e",
        "1e+",  "1.2.3", "--1", "+-1", "yes",  "true",  "~",     " 1",  "1 ",   "١",     "0x1p3"}) {
    INFO("'" << text << "'");
    CHECK(!parseReal(text).wrong.empty());
    CHECK(!parseNatural(text).wrong.empty());
  }
  for (const auto* text : {"1.5", "1e3", "-1", "99999999999999999999"}) CHECK(!parseNatural(text).wrong.empty());
  CHECK(parseReal("1.0 s").wrong == "has trailing text 's'");
  CHECK(parseReal("010").wrong == "has a leading zero, which could mean octal");
  CHECK(parseReal("-.inf").wrong == "is not a finite number");
  CHECK(parseNatural("2.0").wrong == "is not a whole number");
}

TEST_CASE("numbers survive being written and read") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto bits = random();
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value) || value == 0) continue;
    REQUIRE(parseReal(exactText(value)).value == value);
  }
}

TEST_CASE("ranges at and beside their ends") {
  const double beside = std::nextafter(0.0, 1);
  CHECK(!positive.holds(0));
  CHECK(positive.holds(beside));
  CHECK(notNegative.holds(0));
  CHECK(!notNegative.holds(-beside));
  CHECK(positive.text() == "> 0");
  CHECK(notNegative.text() == "≥ 0");
  CHECK(Range{.low = 0, .high = 4}.text() == "from 0 to 4");
  CHECK(!Range{.low = 0, .high = 4}.holds(std::nextafter(4.0, 5)));
}
