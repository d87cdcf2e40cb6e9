// Errors that goldens state: every shipped scene with bodies states them, in one form.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "accuracy/state_error.h"
#include "accuracy/stated_errors.h"
#include "catch.h"
#include "files/read_file.h"

using namespace morula;

namespace {

/// Returns the shipped goldens of scenes with bodies, by scenario.
std::map<std::string, Golden> shippedGoldens() {
  std::map<std::string, Golden> goldens;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("golden")) {
    if (entry.path().extension() != ".golden") continue;
    Golden golden = readGoldenFile(entry.path());
    if (hasBodies(golden)) goldens.emplace(golden.data.scenario, golden);
  }
  return goldens;
}

bool isUnstated(const Golden& golden, const std::string& what) {
  return std::ranges::any_of(all<GoldenUnstated>(golden.stated), [&](const auto* u) { return u->of == what; });
}

}  // namespace

TEST_CASE("Every shipped scene with bodies states its error, or why it has none") {
  // If one is missing, run: morula review SCENARIO --into-golden
  const auto goldens = shippedGoldens();
  CHECK(goldens.size() > 80);
  std::set<std::string> without, withoutMesh;
  for (const auto& [name, golden] : goldens) {
    CAPTURE(name);
    REQUIRE_FALSE(golden.stated.empty());
    const auto errors = errorsOf(golden);
    if (errors.empty()) {
      CHECK(isUnstated(golden, "time"));
      without.insert(name);
      continue;
    }
    std::set<std::string> quantities;
    for (const GoldenError& e : errors) {
      quantities.insert(e.quantity);
      CHECK(std::ranges::any_of(errorQuantities, [&](const ErrorQuantity& q) { return q.name == e.quantity; }));
      CHECK(e.worst >= e.rest.value_or(0));
      CHECK(e.until > 0);
      CHECK((e.meshWorst || isUnstated(golden, "mesh")));
      if (!e.meshWorst) withoutMesh.insert(name);
      CHECK(e.meshWorst.has_value() == e.meshUntil.has_value());
      if (e.meshRest) CHECK(e.meshRest <= e.meshWorst);
    }
    for (const char* always : {"position", "surface", "volume"}) CHECK(quantities.contains(always));
    CHECK(quantities.contains("contact_area") == quantities.contains("neighbours"));
  }
  // Reasons: a law that depends on the time step, steps that no reference can follow, and scenes without time steps.
  CHECK(without == std::set<std::string>{"hard/stiff-xpbd", "hard/thesis-law", "large/four-thousand-cells",
                                         "large/ten-thousand-spheres", "policies/shell-64-settled"});
  // These have no finer mesh of the same shape.
  CHECK(withoutMesh == std::set<std::string>{"hard/sliver-globe", "hard/sliver-lens", "hard/sliver-rod"});
}

TEST_CASE("golden/ERRORS.md is current") {
  // After a change run: morula review golden/*/*.golden --stated > golden/ERRORS.md
  std::vector<Golden> goldens;
  for (const auto& [name, golden] : shippedGoldens()) goldens.push_back(golden);
  CHECK(readFile("golden/ERRORS.md") == statedErrorsAsMarkdown(goldens));
}

TEST_CASE("What a golden states is told with its units; what it does not, with the reason") {
  Golden golden;
  CHECK(statedErrors(golden).empty());
  golden.data.scenario = "a/b";
  golden.stated = {GoldenError{"position", 0.00012, 0.0012, 1.5, 0.003, 0.02, 1.25},
                   GoldenError{"neighbours", {}, 0, 1.5, {}, {}, {}}, GoldenUnstated{"mesh", {"none is finer"}}};
  golden.statistics = {{"clone_radius", "half-step", -0.0012, -0.0041, 0.0017, 8},
                       {"clone_radius", "single", 0.25, 0.25, 0.25, 8, true},
                       {"neighbours", "single", -0.5, -0.5, -0.5, 8}};
  const std::string text = textOf(statedErrors(golden));
  for (const char* part :
       {"position [radii of the egg]", "0.00012", "0.0012", "0.003", "1.25", "not known", "mesh: none is finer",
        "clone_radius", "half-step", "-0.0041", "one path", "no spread", "At rest: the median", "At worst: 2 times"})
    CHECK_THAT(text, ContainsSubstring(part));
  CHECK_THAT(text, !ContainsSubstring(oldErrorNote));
  const std::string all = statedErrorsAsMarkdown({golden});
  const auto worst = all.find("## At worst");
  REQUIRE(worst != all.npos);
  CHECK_THAT(all.substr(0, worst), ContainsSubstring("| a/b | 0.00012 / 0.003 | "));
  CHECK_THAT(all.substr(worst), ContainsSubstring("| a/b | 0.0012 / 0.02 | ") && ContainsSubstring("0 / ?"));
  for (const char* part : {"0.25 (one path)", "-0.5 (no spread)", "-0.0012 (-0.0041 to 0.0017)"})
    CHECK_THAT(all, ContainsSubstring(part));
  CHECK_THAT(all, !ContainsSubstring(oldErrorNote));
}

TEST_CASE("old form: one number is told to be the largest of 16 times, and errors at rest are not known") {
  Golden golden;
  golden.data.scenario = "a/b";
  golden.stated = {OldGoldenError{"position", 0.0012, 1.5, 0.02, 1.25}};
  const std::string text = textOf(statedErrors(golden));
  for (const char* part : {"0.0012", "0.02", "not known", oldErrorNote}) CHECK_THAT(text, ContainsSubstring(part));
  const std::string all = statedErrorsAsMarkdown({golden});
  const auto worst = all.find("## At worst");
  REQUIRE(worst != all.npos);
  CHECK_THAT(all.substr(0, worst), !ContainsSubstring("a/b") && ContainsSubstring(oldErrorNote));
  CHECK_THAT(all.substr(worst), ContainsSubstring("| a/b | 0.0012 / 0.02 | ") && ContainsSubstring(oldErrorNote));
}
