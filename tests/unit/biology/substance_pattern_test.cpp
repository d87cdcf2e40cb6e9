// Patterns that stand for substances.
#include "biology/substance_pattern.h"

#include "catch.h"

using namespace morula;

TEST_CASE("A pattern stands for its name, or for all names that begin like it") {
  CHECK(fits("AB", "AB"));
  CHECK_FALSE(fits("AB", "ABa"));
  CHECK_FALSE(fits("AB", "A"));
  CHECK(fits("AB*", "AB"));
  CHECK(fits("AB*", "ABa"));
  CHECK_FALSE(fits("AB*", "A"));
  CHECK_FALSE(fits("AB*", "aAB"));
  CHECK(fits("*", "AB"));
}

TEST_CASE("A pattern is looked for among all substances of a cell") {
  CHECK(fitsAny("a1", "a1"));
  CHECK(fitsAny("a1", "a0 a1 divide"));
  CHECK(fitsAny("divide", "a0 a1 divide"));
  CHECK_FALSE(fitsAny("a", "a0 a1 divide"));
  CHECK(fitsAny("a1*", "a0 a12 divide"));
  CHECK_FALSE(fitsAny("a2*", "a0 a1 divide"));
  CHECK(fitsAny("*", "a0"));
  CHECK_FALSE(fitsAny("*", ""));
}

TEST_CASE("A beginning never stands for a reserved substance, which all newborns hold, or which acts") {
  for (const char* reserved : {"A", "B", "divide", "die", "grow", "shrink", "connect", "release"}) {
    CAPTURE(reserved);
    CHECK(fits(reserved, reserved));
    for (std::size_t n = 1; n <= std::string(reserved).size(); ++n)
      CHECK_FALSE(fits(std::string(reserved).substr(0, n) + "*", reserved));
    CHECK(fits("*", reserved));  // all substances
  }
  CHECK(fitsAny("A*", "A Ab1"));
  CHECK_FALSE(fitsAny("A*", "A a4 divide"));
  CHECK(includes("A*", "A*"));
}

TEST_CASE("A pattern includes another if it stands for all that the other one does") {
  CHECK(includes("AB", "AB"));
  CHECK(includes("AB*", "AB"));
  CHECK(includes("AB*", "ABa"));
  CHECK(includes("AB*", "ABa*"));
  CHECK(includes("AB*", "AB*"));
  CHECK(includes("*", "AB*"));
  CHECK_FALSE(includes("AB", "AB*"));
  CHECK_FALSE(includes("ABa*", "AB*"));
  CHECK_FALSE(includes("ABa*", "AB"));
}
