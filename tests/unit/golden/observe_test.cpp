// A golden taken from a real run.
#include "golden/observe.h"

#include "biology/full_tree.h"
#include "catch.h"
#include "simulation/world.h"

using namespace morula;

namespace {

Scene twoDivisions(bool mechanics) {
  Scene scene;
  scene.name = "two-divisions";
  scene.seed = 3;
  scene.dna = parseDna(makeFullTreeDna(2), "test.dna");
  scene.cycle.length = 0.125;
  scene.stop.cycles = 3;
  if (mechanics) {
    scene.mechanics.emplace();
    scene.mechanics->mesh = makeIcosphere(1);
    scene.mechanics->physics.membrane.damping = 0.5;
    scene.mechanics->physics.pressure.outside = 1;
    scene.mechanics->physics.drag = 5;
    scene.mechanics->contact.emplace();
    scene.mechanics->connections.emplace();
  }
  return scene;
}

GoldenData observed(bool mechanics) {
  World world = makeWorld(twoDivisions(mechanics));
  while (!finished(world)) step(world);
  return observeGolden(world,
                       {"test/two-divisions", "0123456789abcdef0123456789abcdef", {measureWorld(world)}, {}, {}});
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
  CHECK(has("value", "final/AB/volume") == mechanics);
  CHECK(has("value", "final/organism/volume") == mechanics);
}
