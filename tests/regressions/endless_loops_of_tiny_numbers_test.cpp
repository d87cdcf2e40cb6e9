// `physics.cell.radius=1e-300`, `record.every=1e-12` and `record.pictures=1e-300` ran forever, in loops that doubled
// zero or counted up in floating point. Now numbers outside of sensible ranges are refused, and the next multiple of an
// interval is found in constant time.
#include <cmath>
#include <limits>

#include "base/multiples.h"
#include "catch.h"
#include "launch.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("tiny and huge numbers are refused with the range") {
  for (const char* change :
       {"physics.cell.radius=1e-300", "physics.cell.radius=1e300", "physics.cell.mass=1e-40", "record.every=1e-300",
        "record.pictures=1e-300", "physics.contact.radius=1e-31", "physics.drag=1e31", "cycle.length=1e-300"})
    for (const char* verb : {"validate", "parts"})
      refuses({verb, uniqueFour, "--set", change}, 3, "from 1e-30 to 1e+30");
}

TEST_CASE("intervals that make more samples or pictures than anybody can look at are refused") {
  for (const char* change : {"record.every=1e-12", "record.pictures=1e-6"})
    refuses({"validate", uniqueFour, "--set", change}, 3, "needs at least");
}

TEST_CASE("the next multiple is the one that counting up finds") {
  for (double every : {0.1, 0.25, 1.0 / 3, 0.7, 1.0, 3.1})
    for (double time : {0.0, 0.1, 0.3, 0.30000000000000004, 0.7, 2.1, 2.0999999999999996, 6.0, 100.0, 12345.6}) {
      std::uint64_t counted = 0;
      while (static_cast<double>(counted) * every <= time) ++counted;
      CAPTURE(every, time);
      CHECK(firstMultipleAfter(time, every) == counted);
    }
}

TEST_CASE("the next multiple of a tiny interval is found at once") {
  for (double every : {1e-12, 1e-15, 1e-300, std::numeric_limits<double>::denorm_min()})
    CHECK(firstMultipleAfter(1, every) >= static_cast<std::uint64_t>(std::min(1 / every, 0x1p53)));
}
