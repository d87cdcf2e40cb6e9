// Bullet's run on a page: its shapes as frames, its results in words, and the comparison with stored results.
#include "catch.h"
#include "engines/bullet_scene.h"
#include "loop/simulate.h"
#include "observation/measures.h"
#include "report/bullet_block.h"
#include "report_data/run_facts.h"

namespace morula {
namespace {

const char* const bulletScene = R"(morula: 1
name: one
dna: |
  START: a0
  g1(a0|a0)
cycle: {length: 100}
stop: {time: 0.25}
cells: [{at: [-1.5, 0, 0]}, {at: [1.5, 0, 0]}]
physics: {time_step: 0.0078125, mesh: {icosphere: 1}}
check: {bullet: {}}
)";

/// Returns Bullet's answer if it had found these shapes.
BulletAgain answered(const Scenario& scenario, const World& ours, std::vector<std::vector<Point>> shapes) {
  BulletAgain again;
  again.found.results = compareWithBullet(ours, shapes, tolerancesFor(scenario));
  again.found.bullet.emplace().shapes = std::move(shapes);
  return again;
}

TEST_CASE("Shapes of another engine make the frames that a world of these shapes makes") {
  const Scenario scenario = readScenario(bulletScene, "one.yaml", "");
  const World world = makeScenarioWorld(scenario, {});
  FrameTaker taker(0, 1);
  taker.take(world);
  auto shapes = shapesOf(world);
  const Frames same = framesOf(scenario, {{0, 0, shapes}});
  REQUIRE(same.frames.size() == 1);
  CHECK(same.frames[0].bytes == taker.frames().frames[0].bytes);
  for (Point& p : shapes[1]) p.x += 0.5;
  const Frames moved = framesOf(scenario, {{0, 0, shapesOf(world)}, {0.125, 16, shapes}});
  REQUIRE(moved.frames.size() == 2);
  CHECK(moved.frames[0].bytes == same.frames[0].bytes);
  CHECK(moved.frames[1].bytes != same.frames[0].bytes);
  CHECK(moved.frames[1].bytes.size() == same.frames[0].bytes.size());
  CHECK(moved.frames[1].time == 0.125);
  CHECK(moved.frames[1].step == 16);
  CHECK(moved.frames[1].cells == 2);
}

TEST_CASE("What Bullet gives now is held to what is stored, digit for digit") {
  const std::vector<CheckResult> now{
      {.check = "bullet volume", .kind = CheckKind::bullet, .expected = "1.5", .actual = "1.25"}};
  auto then = now;
  then.insert(then.begin(), CheckResult{.check = "lineage", .kind = CheckKind::golden});
  CHECK(compareWithStored(now, then) == BulletStored::same);
  then[1].expected = "1.5000000000000002";
  CHECK(compareWithStored(now, then) == BulletStored::other);
  CHECK(compareWithStored(now, {}) == BulletStored::none);
}

TEST_CASE("A block beside Bullet says which geometry decides, how far the surfaces are apart, and where") {
  const Scenario scenario = readScenario(bulletScene, "one.yaml", "");
  const World world = makeScenarioWorld(scenario, {});
  auto shapes = shapesOf(world);
  const std::string same = htmlOf(besideBullet(scenario, world, answered(scenario, world, shapes), nullptr, {}));
  CHECK_THAT(same, ContainsSubstring("agree within every tolerance"));
  CHECK_THAT(same, ContainsSubstring("vertex by vertex"));
  CHECK_THAT(same, ContainsSubstring("✓ holds"));
  CHECK_THAT(same, ContainsSubstring("rounding errors only"));
  // Bullet's second cell is larger, so that each vertex lies 0.25 radii farther out.
  for (Point& p : shapes[1]) p = Point{1.5, 0, 0} + 1.25 * (p - Point{1.5, 0, 0});
  const auto larger = answered(scenario, world, shapes);
  const std::string differs =
      htmlOf(besideBullet(scenario, world, larger, &larger.found.results, {.picture = "picture-1", .swipe = true}));
  CHECK_THAT(differs, ContainsSubstring("differ by more than the tolerance in 1 of 1 quantity"));
  CHECK_THAT(differs, ContainsSubstring("✗ does not hold"));
  CHECK_THAT(differs, !ContainsSubstring("rounding errors only"));
  CHECK_THAT(differs, ContainsSubstring("id=\"picture-1\""));
  CHECK_THAT(differs, ContainsSubstring("digit for digit"));
  // Distances from our vertices to the faces of the larger icosphere are between 1.25 · 0.9 − 1 and 1.25 − 1.
  const auto at = differs.find("farthest apart at cell B: ");
  REQUIRE(at != differs.npos);
  const double distance = std::stod(differs.substr(at + 26));
  CHECK(distance > 0.12);
  CHECK(distance < 0.25);
}

TEST_CASE("A Bullet that gave no answer, or is not there, is said to") {
  const Scenario scenario = readScenario(bulletScene, "one.yaml", "");
  const World world = makeScenarioWorld(scenario, {});
  BulletAgain broken;
  broken.found.results = {judged({.check = "bullet",
                                  .kind = CheckKind::bullet,
                                  .expected = "an answer",
                                  .actual = "its process was ended by signal <9>"},
                                 false, "bullet", FailureClass::setup)};
  const std::string html = htmlOf(besideBullet(scenario, world, broken, nullptr, {}));
  CHECK_THAT(html, ContainsSubstring("Bullet: its process was ended by signal &lt;9&gt;."));
  CHECK_THAT(html, !ContainsSubstring("<img"));
  RunFacts facts{};
  facts.scenario = scenario;
  facts.bullet = std::make_unique<BulletAgain>(broken);
  std::vector<Finding> findings;
  judgeBullet(facts, findings);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].kind == Finding::Kind::warning);
  if (bulletIsAvailable()) CHECK(bulletName().starts_with("Bullet 3"));
}

}  // namespace
}  // namespace morula
