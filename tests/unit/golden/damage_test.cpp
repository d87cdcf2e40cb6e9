// Goldens with any damage are noticed and give one failed check.
#include "catch.h"
#include "example_facts.h"

using namespace morula;

namespace {

/// Compares a run with a golden's text, as `morula check` does.
CheckReport compareText(const std::string& text, const GoldenData& observed) {
  try {
    return compareGolden(readGolden(text, "x.golden"), observed);
  } catch (const InputError& e) { return unusableGolden(observed.scenario, e.what()); }
}

}  // namespace

TEST_CASE("Damaged goldens are one failed check, with the line") {
  const std::string text = writeGolden(exampleGolden());
  const GoldenData data = exampleData();
  const std::vector<std::pair<std::string, const char*>> faults{
      {with(text, "volume 1024 2", "volume 1024 3"), "were edited after they had been accepted"},
      {with(text, "why first result\n", "why first result\n<<<<<<< ours\n"), "a merge marker"},
      {text.substr(0, text.size() / 2), ": "},
      {text.substr(0, text.rfind("end ")), "truncated"},
      {"", "empty"},
      {with(text, "count cells 1\n", "count cells 1\ncount cells 1\n"), "stands twice"},
      {with(text, "count cells 1\n", ""), "items"},
  };
  for (const auto& [damaged, why] : faults) {
    CAPTURE(why);
    const CheckReport report = compareText(damaged, data);
    REQUIRE(report.results.size() == 1);
    CHECK_FALSE(report.passed());
    CHECK(report.results[0].failureClass == FailureClass::inputChanged);
    CHECK(report.results[0].check == "golden");
    CHECK_THAT(report.results[0].message, ContainsSubstring("x.golden:") && ContainsSubstring(why));
  }
  CHECK(compareText(text, data).passed());
}
