// Adhesion, springs and connections: how they are read, what they mean, and mistakes that are refused.
#include <set>

#include "helpers.h"
#include "scenario/loading.h"

using namespace morula;
using namespace morula::test;

namespace {

const std::string text =
    "morula: 1\nname: x\ndna: |\n  START: red1, blue\n  g1(red2|red1)\n  g2(blue|blue)\nstop: {time: 1}\n"
    "physics: {drag: 1, contact: {stiffness: 30}}\nconnections: {}\n";

Scenario with(const std::string& path, const std::string& value) { return read(text, {{path, value, "--set"}}); }

std::string refusal(const std::string& path, const std::string& value) {
  return complaints(text, {{path, value, "--set"}});
}

bool has(const std::string& whole, const std::string& part) { return whole.find(part) != whole.npos; }

}  // namespace

TEST_CASE("adhesion is one number, or a default and pairs of substances, and both count") {
  CHECK(!read(text).scene.mechanics->contact->adhesion);
  const auto one = with("physics.contact.adhesion", "2");
  CHECK(one.scene.mechanics->contact->adhesion->strength == 2);
  CHECK(one.scene.mechanics->contact->adhesion->pairs.empty());
  CHECK(with("physics.contact.adhesion", "{default: 2}").meaning == one.meaning);
  const auto pairs = with("physics.contact.adhesion",
                          "{default: 1, pairs: [{of: [red1, 'red*'], strength: 1.5}, {of: ['*', blue], strength: 0}]}");
  const AdhesionParameters& a = *pairs.scene.mechanics->contact->adhesion;
  CHECK(a.strength == 1);
  REQUIRE(a.pairs.size() == 2);
  CHECK(a.pairs[0].a == "red1");
  CHECK(a.pairs[0].b == "red*");
  CHECK(a.pairs[0].strength == 1.5);
  CHECK(a.pairs[1].strength == 0);
  // The resolved form means the same as the scenario.
  CHECK(readScenario(pairs.resolved, "resolved", "").meaning == pairs.meaning);
  std::set<std::string> meanings;
  for (const char* value : {"2", "1", "{default: 1, pairs: [{of: [red1, blue], strength: 1.5}]}",
                            "{default: 1, pairs: [{of: [red1, blue], strength: 2}]}",
                            "{default: 1, pairs: [{of: [red1, red2], strength: 2}]}"})
    meanings.insert(with("physics.contact.adhesion", value).meaning.text());
  meanings.insert(read(text).meaning.text());
  CHECK(meanings.size() == 6);
}

TEST_CASE("adhesion that can have no effect, or a bad one, is refused") {
  const std::string path = "physics.contact.adhesion";
  CHECK(has(refusal(path, "2.5"), "physics.membrane.stiffness of at least 12.5"));
  CHECK(refusal(path, "2").empty());
  CHECK(has(refusal(path, "{pairs: [{of: [red1, blue], strength: 6}]}"), "stiffness of at least 60"));
  CHECK(has(refusal(path, "-1"), "a number ≥ 0"));
  CHECK(has(refusal(path, "{}"), "is empty"));
  CHECK(has(refusal(path, "{pairs: []}"), "is empty"));
  CHECK(has(refusal(path, "{defualt: 2}"), "did you mean default?"));
  CHECK(has(refusal(path, "{pairs: [{of: [red1, blu], strength: 2}]}"), "did you mean blue?"));
  CHECK(has(refusal(path, "{pairs: [{of: [red1, 'green*'], strength: 2}]}"), "begins with 'green'"));
  CHECK(has(refusal(path, "{pairs: [{of: [red1], strength: 2}]}"), "has 1 entry"));
  CHECK(has(refusal(path, "{pairs: [{of: [red1, blue]}]}"), "strength: is missing"));
  CHECK(has(refusal(path, "{pairs: [{of: ['red*', blue], strength: 1}, {of: [blue, red1], strength: 2}]}"),
            "never counts"));
  CHECK(refusal(path, "{pairs: [{of: [blue, red1], strength: 1}, {of: ['red*', blue], strength: 2}]}").empty());
  const Override thesis{"physics.contact.law", "thesis", "--set"};
  CHECK(has(complaints(text, {{path, "1", "--set"}, thesis}), "law pair"));
}

TEST_CASE("connections may be springs, and are released by their tension") {
  const auto spring = with("connections.spring", "{stiffness: 3, rest: 0.5}");
  CHECK(spring.scene.mechanics->connections->spring->stiffness == 3);
  CHECK(spring.scene.mechanics->connections->spring->rest == 0.5);
  CHECK(with("connections.spring", "{}").meaning != read(text).meaning);
  CHECK(with("connections.spring", "{rest: 0.5}").meaning != spring.meaning);
  CHECK(has(refusal("connections", "{spring: {}, strength: 1}"), "give one of strength or spring"));
  CHECK(has(refusal("connections.release-tension", "2"), "add 'spring: {}'"));
  const auto weak = with("connections", "{spring: {}, release-tension: 2}");
  CHECK(weak.scene.mechanics->connections->releaseTension == 2);
  CHECK(weak.meaning != with("connections", "{spring: {}}").meaning);
}

TEST_CASE("who connects: words, or pairs of substances that the DNA knows") {
  const auto makeOf = [](const std::string& value) {
    return with("connections.make", value).scene.mechanics->connections->make;
  };
  CHECK(makeOf("at-division") == MakeConnections::atDivision);
  CHECK(makeOf("by-contact") == MakeConnections::byContact);
  const auto pairs = with("connections.make", "{pairs: [[red1, blue], ['red*', red2]]}");
  const ConnectionParameters& c = *pairs.scene.mechanics->connections;
  CHECK(c.make == MakeConnections::pairs);
  REQUIRE(c.pairs.size() == 2);
  CHECK(c.pairs[1].a == "red*");
  CHECK(c.pairs[1].b == "red2");
  CHECK(readScenario(pairs.resolved, "resolved", "").meaning == pairs.meaning);
  const std::string path = "connections.make";
  CHECK(has(refusal(path, "pairs"), "is not known here"));
  CHECK(has(refusal(path, "by-contcat"), "did you mean by-contact?"));
  CHECK(has(refusal(path, "{pairs: []}"), "is empty"));
  CHECK(has(refusal(path, "{pairs: [[red1, grue]]}"), "grue"));
  CHECK(has(refusal(path, "{pairs: [['*', '*'], [red1, blue]]}"), "never counts"));
  CHECK(has(complaints(text, {{path, "by-contact", "--set"}, parseOverride("physics.contact=null")}),
            "cells do not touch without physics.contact"));
}

TEST_CASE("cells crawl against a drag, and adhesion varies where there is some") {
  CHECK(has(complaints(text, {{"physics.motility", "{}", "--set"}, {"physics.drag", "0", "--set"}}),
            "cells crawl against the drag"));
  const auto crawling = with("physics.motility", "{speed: 0.2, persistence: 0.5}");
  CHECK(crawling.scene.mechanics->physics.motility->speed == 0.2);
  CHECK(crawling.scene.mechanics->physics.motility->persistence == 0.5);
  std::set<std::string> meanings{read(text).meaning.text(), crawling.meaning.text()};
  for (const char* value : {"{}", "{speed: 0.2}", "{persistence: 0.5}"})
    meanings.insert(with("physics.motility", value).meaning.text());
  CHECK(meanings.size() == 5);
  CHECK(has(refusal("variation", "{adhesion: 0.1}"), "physics.contact.adhesion"));
  const auto varied =
      read(text, {{"variation", "{adhesion: 0.1}", "--set"}, {"physics.contact.adhesion", "1", "--set"}});
  CHECK(varied.scene.variation.adhesion == 0.1);
  CHECK(varied.meaning != with("physics.contact.adhesion", "1").meaning);
}
