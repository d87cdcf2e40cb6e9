// Errors that goldens state: every shipped scene with bodies states them, in one form.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "accuracy/into_golden.h"
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
    const auto errors = all<GoldenError>(golden.stated);
    if (errors.empty()) {
      CHECK(isUnstated(golden, "time"));
      without.insert(name);
      continue;
    }
    std::set<std::string> quantities;
    for (const GoldenError* e : errors) {
      quantities.insert(e->quantity);
      CHECK(std::ranges::any_of(errorQuantities, [&](const ErrorQuantity& q) { return q.name == e->quantity; }));
      CHECK(e->time >= 0);
      CHECK(e->until > 0);
      CHECK((e->mesh || isUnstated(golden, "mesh")));
      if (!e->mesh) withoutMesh.insert(name);
      CHECK(e->mesh.has_value() == e->meshUntil.has_value());
    }
    for (const char* always : {"position", "surface", "volume"}) CHECK(quantities.contains(always));
    CHECK(quantities.contains("contact_area") == quantities.contains("neighbours"));
  }
  // Reasons: a law that depends on the time step, steps that no reference can follow, and a scene without time steps.
  CHECK(without == std::set<std::string>{"hard/stiff-xpbd", "hard/thesis-law", "policies/shell-64-settled"});
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
  golden.stated = {GoldenError{"position", 0.0012, 1.5, 0.02, 1.25}, GoldenError{"neighbours", 0, 1.5, {}, {}},
                   GoldenUnstated{"mesh", {"none is finer"}}};
  golden.statistics = {{"clone_radius", "half-step", -0.0012, -0.0041, 0.0017, 8}};
  const std::string text = textOf(statedErrors(golden));
  for (const char* part : {"position [radii of the egg]", "0.0012", "1.25", "not known", "mesh: none is finer",
                           "clone_radius", "half-step", "-0.0041"})
    CHECK_THAT(text, ContainsSubstring(part));
  const std::string row = statedErrorsAsMarkdown({golden});
  for (const char* part : {"a/b", "0.0012 / 0.02", "0 / ?"}) CHECK_THAT(row, ContainsSubstring(part));
}
