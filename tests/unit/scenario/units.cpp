// The units in which results are shown.
#include "values/units.h"

#include "helpers.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("lengths and times are shown in the units that people know, and what is made of them alone") {
  const Units units{"µm", "min", 27, 4};
  const auto check = [&](const char* unit, const char* shown, double factor) {
    INFO(unit);
    CHECK(shownUnit(units, unit).name == shown);
    CHECK(shownUnit(units, unit).factor == factor);
    CHECK(shownUnit({}, unit).name == unit);
    CHECK(shownUnit({}, unit).factor == 1);
  };
  check("length", "µm", 27);
  check("length²", "µm²", 729);
  check("length³", "µm³", 19683);
  check("time", "min", 4);
  check("1/time", "1/min", 0.25);
  check("1/time²", "1/min²", 0.0625);
  check("length/time", "µm/min", 27.0 / 4);
  check("length·time", "µm·min", 108);
  for (const char* own :
       {"", "degree", "shell radii", "force", "force/length²", "force·length/time", "mass·length/time"})
    check(own, own, 1);
  CHECK(shownUnit({"µm", "", 27, 1}, "length/time").name == "length/time");  // units of both kinds are never mixed
  CHECK(shownUnit({"µm", "", 27, 1}, "length²").name == "µm²");
  CHECK(shownTime(units, 1.5) == "6 min");
  CHECK(shownTime({}, 1.5) == "1.5");
  CHECK(timeLabel(units) == "time [min]");
  CHECK(timeLabel({}) == "time");
}

TEST_CASE("runs that see one unit share it, others have the scene's own") {
  const Units a{"µm", "", 27, 1}, b{"µm", "", 26, 1};
  const auto itself = [](const Units& units) { return units; };
  CHECK(unitsOfAll(std::vector{a, a}, itself) == a);
  CHECK(unitsOfAll(std::vector{a, b}, itself) == Units{});
  CHECK(unitsOfAll(std::vector<Units>{}, itself) == Units{});
}

TEST_CASE("units are read, with one of what is not said") {
  CHECK(read(everyPart).units == Units{"um", "min", 27, 4});
  CHECK(read(small).units == Units{});
  CHECK(read(small + "units: {time: h}\n").units == Units{"", "h", 1, 1});
}
