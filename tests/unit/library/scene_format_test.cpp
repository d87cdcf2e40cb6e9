// A scene as a text: a written text is read back whole, and nothing else is read.
#include "library/scene_format.h"

#include <limits>

#include "base/hash.h"
#include "catch.h"
#include "scenes.h"
#include "state/scene_parts.h"

using namespace morula;

namespace {

std::vector<Scene> scenesOfAllKinds() {
  Scene starting = scenes::withBodies(scenes::uniqueFour, 2);
  starting.cells = {{.at = {1, -0.0, 3}},
                    {.at = {2, 0, 1e-310}, .mass = 2, .substances = std::vector<std::string>{"a0"}}};
  starting.senses = {{.substance = "touched", .kind = SenseKind::contact, .number = 0.5}};
  starting.mechanics->division.rules = {{.of = {"a*"}, .share = 0.6, .chirality = Chirality{}}};
  starting.cycle.perSubstance = {{"a0", 1.5}, {"a1", std::numeric_limits<double>::infinity()}};
  starting.name = "two\nlines";
  return {scenes::lineageOnly(scenes::uniqueFour, 3), scenes::packed(), scenes::ellipsoid(), scenes::life(), starting};
}

/// Returns the body followed by its hash.
std::string signedText(const std::string& body) { return body + "hash " + Hasher().add(body).digest().text() + "\n"; }
std::string bodyOf(const std::string& text) { return text.substr(0, text.size() - 38); }

std::string refusalOf(const std::string& text) {
  try {
    readScene(text, "a.scene");
  } catch (const InputError& error) { return error.what(); }
  return "";
}

/// Returns the text with a line of its body, counted from 1, replaced, and with a hash that fits.
std::string withLine(const std::string& text, int number, const std::string& line) {
  std::string body = bodyOf(text);
  std::size_t from = 0;
  for (int i = 1; i < number; ++i) from = body.find('\n', from) + 1;
  return signedText(body.replace(from, body.find('\n', from) - from, line));
}

}  // namespace

TEST_CASE("A scene is read back as it was written, to the bit") {
  for (const Scene& scene : scenesOfAllKinds()) {
    const std::string text = writeScene(scene);
    const Scene again = readScene(text, "a.scene");
    CHECK(writeScene(again) == text);
    CHECK(again.name == scene.name);
    const auto parts = hashSceneParts(scene), same = hashSceneParts(again);
    REQUIRE(parts.size() == same.size());
    for (std::size_t i = 0; i < parts.size(); ++i) CHECK(parts[i].hash == same[i].hash);
  }
}

TEST_CASE("A text that was changed anywhere, cut off or continued is no scene") {
  const std::string text = writeScene(scenes::lineageOnly(scenes::uniqueFour, 3));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string other = text;
    other[i] = other[i] == '7' ? '8' : '7';
    CAPTURE(i);
    CHECK(refusalOf(other).starts_with("a.scene:1: "));
    CHECK(refusalOf(text.substr(0, i)) != "");
  }
  CHECK_THAT(refusalOf(text + "\n"), ContainsSubstring("text follows it"));
  std::string changed = text;
  changed[changed.find("lineage-only")] = 'L';
  CHECK_THAT(refusalOf(changed), ContainsSubstring("the scene was changed after it had been written"));
}

TEST_CASE("What is wrong in a scene is told with its line") {
  const Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
  const std::string text = writeScene(scene);
  const auto body = bodyOf(text);
  CHECK(refusalOf("") == "a.scene:1: the text is no scene; a scene begins with \"morula-scene 3\"");
  CHECK_THAT(refusalOf(withLine(text, 1, "morula-scene 2")),
             ContainsSubstring("a.scene:1: a scene of another version; needs 3"));
  CHECK_THAT(refusalOf(withLine(text, 2, "99999 with-bodies")),
             ContainsSubstring("a.scene:2: a text of 99999 bytes is cut off"));
  CHECK_THAT(refusalOf(withLine(text, 2, "11with-bodies")), ContainsSubstring("a.scene:2: needs a blank and a text"));
  for (const char* number : {"01", "+1", "-1", "1 ", " 1", "0x1", "1.5", "", "18446744073709551616"}) {
    CAPTURE(number);
    CHECK_THAT(refusalOf(withLine(text, 3, number)), ContainsSubstring("a.scene:3: needs "));
  }
  CHECK_THAT(refusalOf(withLine(text, 4, "1000000000000")),
             ContainsSubstring("a.scene:4: a list of 1000000000000 is longer"));
  CHECK_THAT(refusalOf(signedText(body + "0\n")), ContainsSubstring("the scene is complete; nothing may follow"));
  CHECK_THAT(refusalOf(signedText(body.substr(0, body.size() - 2))), ContainsSubstring("needs"));
}

TEST_CASE("Numbers that a member cannot be are refused") {
  const auto refused = [](const auto& change) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
    change(scene);
    return refusalOf(writeScene(scene));
  };
  CHECK(refused([](Scene&) {}) == "");
  CHECK_THAT(refused([](Scene& s) { s.cycle.length = std::numeric_limits<double>::quiet_NaN(); }),
             ContainsSubstring("these bits are not those of a finite number"));
  CHECK_THAT(refused([](Scene& s) { s.mechanics->physics.integrator = Integrator(77); }),
             ContainsSubstring("77 is no value"));
  CHECK_THAT(refused([](Scene& s) { s.mechanics->division.otherwise.plane = DivisionPlane(13); }),
             ContainsSubstring("13 is no value"));
  CHECK_THAT(refused([](Scene& s) { s.senses = {{.kind = SenseKind(13)}}; }), ContainsSubstring("13 is no value"));
  CHECK_THAT(refused([](Scene& s) { s.dna.genes[0].product = 1000; }),
             ContainsSubstring("a substance that is not in its list"));
  CHECK_THAT(refused([](Scene& s) { s.mechanics->mesh.faces[0][1] = 42; }), ContainsSubstring("names vertex 42"));
  CHECK_THAT(refused([](Scene& s) { std::swap(s.mechanics->mesh.faces[0][1], s.mechanics->mesh.faces[0][2]); }),
             ContainsSubstring("a mesh of the scene: "));
  CHECK_THAT(refused([](Scene& s) { s.mechanics->mesh.faces[0][1] = -1; }), ContainsSubstring("names vertex -1"));
}
