// A golden's scenario from its own parameters, and pictures of it beside a run that differs.
#include "check/golden_scenario.h"

#include "catch.h"
#include "check/beside_golden.h"
#include "check/check_run.h"
#include "files/read_file.h"
#include "loop/simulate.h"
#include "scenario/deciding_values.h"

using namespace morula;

namespace {

const std::string small =
    "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\n  g2(b0|a0,A)\nstop: {time: 1.25}\n"
    "physics: {mesh: {icosphere: 1}, drag: 5, contact: {}}\n";

Scenario scenarioOf(const std::string& text) { return readScenario(text, "/nowhere/small.yaml", ""); }

Golden goldenOf(const Scenario& scenario) {
  Golden golden;
  golden.file = "/nowhere/small.golden";
  golden.data.scenarioHash = scenario.meaning.text();
  golden.data.parameters = decidingValues(scenario);
  return golden;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  text.replace(text.find(what), what.size(), by);
  return text;
}

std::optional<Scenario> found(const std::string& now, const std::string& before) {
  return goldenScenario(scenarioOf(now), goldenOf(scenarioOf(before)));
}

Simulation runOf(const Scenario& scenario) {
  return simulate(scenario, Execution{}, {.record = recordingOf(scenario, true)});
}

}  // namespace

TEST_CASE("a golden's scenario is made of its parameters, whatever has been changed") {
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"drag: 5", "drag: 7"},
      {"drag: 5, ", ""},
      {"drag: 5", "drag: 5, shell: {sphere: 1.5}"},
      {"drag: 5", "drag: 5, shell: {ellipsoid: [2, 1.5, 1.5]}"},
      {"drag: 5", "drag: 5, growth: {}"},
      {"contact: {}", "contact: {stiffness: 12, viscosity: 0}"},
      {", contact: {}", ""},
      {"time: 1.25", "cycles: 1"},
      {"icosphere: 1", "icosphere: 2"},
      {"physics:", "cycle: {length: 2, per-substance: {b0: 0.5}}\nphysics:"},
      {"physics:", "division: {plane: random}\nphysics:"},
      {"physics:", "division: {rules: [{of: [divide], plane: {axis: [1, 0, 0]}, share: 0.4}]}\nphysics:"},
      {"physics:", "variation: {share: 0.1}\nseed: 7\nphysics:"},
      {"physics:", "connections: {make: at-division}\nphysics:"},
      {"physics:", "cells: [{at: [-2, 0, 0]}, {at: [2, 0, 0], scale: 0.5}]\nphysics:"},
      {"  g2(b0|a0,A)", "  g2(c0|a0,A)"}};  // short enough to be recorded in full
  for (const auto& [what, by] : changes) {
    const std::string other = replaced(small, what, by);
    INFO(other);
    REQUIRE(scenarioOf(other).meaning != scenarioOf(small).meaning);
    const auto there = found(small, other), back = found(other, small);
    REQUIRE(there);
    REQUIRE(back);
    CHECK(there->meaning == scenarioOf(other).meaning);
    CHECK(back->meaning == scenarioOf(small).meaning);
    for (const auto& [what2, by2] : {changes[0], changes[5]}) {  // undoes two changes at once
      if (other.find(what2) == other.npos) continue;
      const auto both = found(replaced(other, what2, by2), small);
      REQUIRE(both);
      CHECK(both->meaning == scenarioOf(small).meaning);
    }
  }
  CHECK(found(small, small)->meaning == scenarioOf(small).meaning);
}

TEST_CASE("a list that is recorded item by item is put together again") {
  const std::string file = "scenarios/worm/four-cell.yaml", text = readFile(file);
  const auto read = [&](const std::string& what) { return readScenario(what, file, folderOf(file)); };
  const Scenario now = read(replaced(text, "share: 0.59", "share: 0.55"));
  const auto before = goldenScenario(now, goldenOf(read(text)));
  REQUIRE(before);
  CHECK(before->meaning == read(text).meaning);
  CHECK(before->meaning != now.meaning);
}

TEST_CASE("what a golden records as a hash alone is not made up") {
  std::string genes;
  for (int i = 0; i < 20; ++i) genes += "  h" + std::to_string(i) + "(p" + std::to_string(i) + "|a0,A)\n";
  const std::string large = replaced(small, "stop:", genes + "stop:");
  REQUIRE(scenarioOf(large).meaning != scenarioOf(small).meaning);
  CHECK_FALSE(found(small, large));
  CHECK(found(large, small));
  Golden older = goldenOf(scenarioOf(large));
  older.data.parameters.clear();
  CHECK_FALSE(goldenScenario(scenarioOf(small), older));
}

TEST_CASE("golden, now and difference: from the same state, from the golden's numbers, or not at all") {
  const Scenario before = scenarioOf(small), now = scenarioOf(replaced(small, "drag: 5", "drag: 7"));
  const Simulation ranBefore = runOf(before), ranNow = runOf(now);
  Golden golden = goldenOf(before);
  golden.data = observe(before, ranBefore, false);
  using Source = BesideGolden::Source;

  const BesideGolden exact = drawBesideGolden(now, ranNow.world, golden, {}, true);
  CHECK(exact.source == Source::again);
  CHECK(exact.images.unmatched.empty());
  CHECK(exact.images.one != exact.images.other);
  CHECK(exact.sheet().width() > 3 * 700);
  CHECK_THAT(exact.notes.at(0), ContainsSubstring("bit for bit"));
  // The first picture shows the golden's run, as the golden's own comparison shows it.
  const BesideGolden back = drawBesideGolden(before, ranBefore.world, goldenOf(now), {}, true);
  CHECK(back.source == Source::none);  // no bits, no values
  CHECK_THAT(back.notes.at(0), ContainsSubstring("cannot be shown"));

  const BesideGolden same = drawBesideGolden(before, ranBefore.world, golden, {}, true);
  CHECK(same.source == Source::none);
  CHECK_THAT(same.notes.at(0), ContainsSubstring("bit for bit"));
  CHECK(same.images.distance.pixels.empty());

  Golden other = golden;  // as from another build
  for (GoldenItem& item : other.data.items)
    if (auto* bits = std::get_if<GoldenBits>(&item)) bits->hash = {};
  for (const auto& [scenario, run] : {std::pair(&before, &ranBefore), std::pair(&now, &ranNow)}) {
    const BesideGolden spheres = drawBesideGolden(*scenario, run->world, other, {}, true);
    CHECK(spheres.source == Source::centres);
    CHECK_THAT(spheres.notes.at(0), ContainsSubstring("spheres") && ContainsSubstring("other bits"));
    CHECK_FALSE(spheres.images.distance.pixels.empty());
  }
}
