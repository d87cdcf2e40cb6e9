// A golden taken from a real run.
#include "golden/observe.h"

#include "catch.h"
#include "scenes.h"

using namespace morula;

namespace {

GoldenData observed(bool mechanics) {
  Scene scene = mechanics ? scenes::life() : scenes::lineageOnly(scenes::eventful, 6);
  scene.seed = 3;
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  GoldenFacts facts;
  facts.scenario = "test/life", facts.scenarioHash = "0123456789abcdef0123456789abcdef";
  facts.samples = {measureWorld(world)};
  return observeGolden(world, facts);
}

}  // namespace

TEST_CASE("a run agrees with the golden made of the same run") {
  const bool mechanics = GENERATE(false, true);
  const GoldenData first = observed(mechanics);
  Golden golden{first, "A. Tester", "why", {}, "x.golden"};
  golden = readGolden(writeGolden(golden), golden.file);
  const CheckReport report = compareGolden(golden, observed(mechanics));
  INFO(describe(report));
  CHECK(report.passed());
  CHECK(first.seed == 3);
  const auto has = [&](const std::string& kind, const std::string& key) {
    return std::any_of(first.items.begin(), first.items.end(),
                       [&](auto& i) { return kindOf(i) == kind && keyOf(i) == key; });
  };
  CHECK(has("cell", "egg"));
  CHECK(has("cell", "AB"));
  CHECK(has("bits", "solver"));
  CHECK(has("value", "final/AAA/volume") == mechanics);
  CHECK(has("value", "final/organism/volume") == mechanics);
}
