// The section `senses`: conditions arrive, change the meaning, and are written so that they can be read.

#include "biology/sense.h"
#include "state/scene_parts.h"
#include "values/value_types.h"
// Included last, because of CHECK:
#include "helpers.h"

using namespace morula;
using namespace morula::test;

namespace {

/// Returns a scene that allows every kind of sense, with the given condition as `s`.
std::string sensing(const std::string& condition) {
  return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(x|s)\n  g3(AB|a0, s)\nstop: {cycles: 1}\n"
         "physics: {shell: {sphere: 2}, contact: {}}\nconnections: {}\nsenses: {s: " +
         condition + "}\n";
}

const std::vector<std::string> good = {
    "{volume: {below: 0.9}}",
    "{volume: {below: 0.9, until: 0.95}}",
    "{volume: {at-most: 0.9}}",
    "{volume: {above: 0.9}}",
    "{volume: {at-least: 0.9}}",
    "{volume: {above: 0.5, below: 0.9}}",
    "{pressure: {above: 2}}",
    "{age: {above: 3}}",
    "{elongation: {above: 1.3}}",
    "{shell: {above: 0.1}}",
    "{position: {axis: [1, 0, 0], above: 0.3}}",
    "{position: {axis: [0, 1, 0], above: 0.3}}",
    "{neighbours: {at-least: 6}}",
    "{neighbours: {of: a0, at-least: 6}}",
    "{contact: {of: a0}}",
    "{contact: {of: AB}}",
    "{contact: {of: 'a*'}}",
    "{contact: {of: a0, area: 0.02}}",
    "{majority: {of: a0}}",
    "{near: {of: a0, distance: 2}}",
    "{near: {of: a0, distance: 3}}",
    "{diffusion: {of: a0, range: 1.5, at-least: 0.2}}",
    "{diffusion: {of: a0, range: 2, at-least: 0.2}}",
    "{connected: {}}",
    "{connected: {to: a0}}",
    "{sister: {holds: a0}}",
    "{sister: {lives: true}}",
    "{sister: {lives: false}}",
};

}  // namespace

TEST_CASE("each condition is read, written as it is read, and means something of its own") {
  std::vector<Hash> seen{read(replaced(sensing("{age: {above: 1}}"), "above: 1", "above: 9")).meaning};
  std::vector<std::string> states;
  for (const std::string& condition : good) {
    INFO(condition);
    const Scenario s = read(sensing(condition));
    REQUIRE(s.scene.senses.size() == 1);
    CHECK(s.scene.senses[0].substance == "s");
    CHECK(std::find(seen.begin(), seen.end(), s.meaning) == seen.end());
    seen.push_back(s.meaning);
    const Scenario again = read(s.resolved);
    CHECK(again.resolved == s.resolved);
    CHECK(again.meaning == s.meaning);
    const ScenePart part = hashSceneParts(s.scene).back();
    CHECK(part.name == "senses");
    CHECK(std::find(states.begin(), states.end(), part.hash) == states.end());
    states.push_back(part.hash);
  }
}

TEST_CASE("what a condition says arrives in its fields") {
  const auto senseOf = [](const std::string& condition) { return read(sensing(condition)).scene.senses.at(0); };
  const SenseParameters contact = senseOf("{contact: {of: 'a*', area: 0.02}}");
  CHECK((contact.kind == SenseKind::contact && contact.of == "a*" && contact.number == 0.02));
  const SenseParameters position = senseOf("{position: {axis: [1, -2, 3], above: -0.3, below: 4}}");
  CHECK((position.axis == Vector{1, -2, 3} && position.is.above == -0.3 && position.is.below == 4.0));
  const SenseParameters crowd = senseOf("{neighbours: {at-least: 5, until: 4}}");
  CHECK((crowd.is.atLeast == 5.0 && crowd.is.until == 4.0 && crowd.of.empty() && !crowd.number));
  CHECK((senseOf("{volume: {at-most: 0.5}}").is.atMost == 0.5));
  CHECK((senseOf("{sister: {lives: false}}").lives == false && senseOf("{sister: {holds: AB}}").of == "AB"));
  CHECK(senseOf("{connected: {to: AB}}").of == "AB");
}

TEST_CASE("every kind is in the schema and in the list for people") {
  const Json schema = scenario::senses().schema;
  CHECK(schema["additionalProperties"]["oneOf"].size() == senseKinds().size());
  for (const SenseKindRow* row : senseKinds())
    CHECK(scenario::sensesAsMarkdown().find("| `" + std::string(row->name) + "` |") != std::string::npos);
}

TEST_CASE("a scenario without senses means what it always meant; what senses read counts as read") {
  const std::string text = "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 1}\n";
  CHECK(read(text).meaning == read(text + "senses: {}\n").meaning);
  for (const ScenePart& part : hashSceneParts(read(text).scene)) CHECK(part.name != "senses");
  // Cells perceive a5 in others, and no gene reads it.
  CHECK(complaints("morula: 1\nname: x\ndna: |\n  START: a0, a5\n  g1(a1|a0, s)\nstop: {cycles: 1}\nphysics: "
                   "{contact: {}}\nsenses: {s: {contact: {of: a5}}}\n") == "");
}
