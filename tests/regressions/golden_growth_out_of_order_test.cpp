// The lines `growth` of a golden were read in any order, and the chaos horizon was that of the first. Now lines that
// are out of order, repeated or out of range are refused, with their place.
#include "catch.h"
#include "golden/golden.h"

using namespace morula;

TEST_CASE("growth lines of a golden rise in size and do not fall in step") {
  const auto text = [](std::vector<GoldenGrowth> growth) {
    Golden golden;
    golden.data = {"x", "h", 1, {GoldenCount{"steps", 100}}};
    golden.acceptedBy = "tests", golden.why = "a test", golden.growth = std::move(growth);
    return writeGolden(golden);
  };
  const auto reads = [&](std::vector<GoldenGrowth> growth) {
    return readGolden(text(std::move(growth)), "x.golden").growth.size();
  };
  CHECK(reads({{1e-9, 10}, {1e-8, 10}, {1, 100}}) == 3);
  struct Bad {
    std::vector<GoldenGrowth> growth;
    const char* said;
  };
  for (const Bad& bad :
       {Bad{{{1e-8, 10}, {1e-9, 20}}, "stands after 1e-08"}, Bad{{{1e-8, 10}, {1e-8, 10}}, "stands twice"},
        Bad{{{1e-9, 20}, {1e-8, 10}}, "before the smaller"}, Bad{{{10, 20}}, "above 1 radius"},
        Bad{{{1e-9, 101}}, "after the run's last, 100"}}) {
    CAPTURE(bad.said);
    CHECK_THROWS_WITH(reads(bad.growth), Catch::Matchers::StartsWith("x.golden:") && ContainsSubstring(bad.said));
  }
}
