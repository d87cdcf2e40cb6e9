#include "helpers.h"

using namespace morula;
using namespace morula::test;

TEST_CASE("overrides go through the same table") {
  CHECK(read(everyPart, {parseOverride("physics.time_step=auto")}).scene.mechanics->physics.timeStep == std::nullopt);
  CHECK(read(everyPart, {parseOverride("physics.shell={sphere: 4}")}).scene.mechanics->physics.shell->semiAxes[2] == 4);
  CHECK(read(everyPart, {parseOverride("summary=a: b # c")}).summary == "a: b # c");
  CHECK(read(everyPart, {{"seed", "9", "--seed"}}).scene.seed == 9);
  CHECK(read(everyPart, {parseOverride("division.plane.axis=[1, 0, 0]")}).scene.mechanics->division.otherwise.axis ==
        Vector{1, 0, 0});
}

TEST_CASE("overrides make the maps that are missing") {
  const auto s = read(small, {parseOverride("physics.contact.viscosity=0.5")});
  CHECK(s.scene.mechanics->contact->viscosity == 0.5);
  CHECK(read(small, {parseOverride("division.plane=random"), parseOverride("physics={}")}).scene.mechanics);
}

TEST_CASE("null takes away what the file gives, whole sections too") {
  REQUIRE(read(everyPart).scene.mechanics->physics.shell);
  for (const char* nothing : {"null", "~"}) {
    CHECK_FALSE(
        read(everyPart, {parseOverride(std::string("physics.shell=") + nothing)}).scene.mechanics->physics.shell);
    CHECK(read(everyPart, {parseOverride(std::string("physics.drag=") + nothing)}).scene.mechanics->physics.drag ==
          PhysicsParameters{}.drag);
  }
  // Removing an absent key changes nothing, but an unknown key is a mistake.
  CHECK(read(everyPart, {parseOverride("check.bullet=null")}).resolved == read(everyPart).resolved);
  CHECK(complaints(everyPart, {parseOverride("physics.contct=null")}) ==
        "--set physics.contct: unknown key; did you mean contact?");
  CHECK_THAT(complaints(everyPart, {parseOverride("name=null")}), ContainsSubstring("test.yaml:1:1: name: is missing"));
  CHECK(complaints(everyPart, {{"seed", "null", "--seed"}}) ==
        "--seed: is empty; needs a whole number from 0 to 9223372036854775807");
}

TEST_CASE("the resolved form holds the overrides, the bytes do not") {
  const auto s = read(everyPart, {parseOverride("physics.drag=0.5")});
  CHECK(s.bytes == everyPart);
  CHECK(read(s.resolved).scene.mechanics->physics.drag == 0.5);
}

TEST_CASE("mistakes in overrides name the option") {
  const auto told = [](const std::string& set) { return complaints(everyPart, {parseOverride(set)}); };
  CHECK(told("physics.tme_step=0.1") == "--set physics.tme_step: unknown key; did you mean time_step?");
  CHECK(told("phyics.drag=0.1") == "--set phyics.drag: phyics: unknown key; did you mean physics?");
  CHECK(told("physics.drag=-1") == "--set physics.drag: -1 is out of range; needs a number ≥ 0 [1/time]");
  CHECK(told("physics.drag=") == "--set physics.drag: is empty; needs a number ≥ 0 [1/time]");
  CHECK(told("physics.drag=0.1 s") == "--set physics.drag: '0.1 s' has trailing text 's'; needs a number ≥ 0 [1/time]");
  CHECK(told("physics.shell={sphere: 1") ==
        "--set physics.shell: '{sphere: 1' is not a YAML value; check brackets, quotes and keys");
  CHECK(told("physics.shell={sphre: 1}") ==
        "--set physics.shell: physics.shell.sphre: unknown key; did you mean sphere?");
  CHECK(complaints(everyPart, {{"seed", "-1", "--seed"}}) ==
        "--seed: '-1' is negative; needs a whole number from 0 to 9223372036854775807");
  CHECK(complaints(everyPart, {parseOverride("seed=1"), parseOverride("seed=2")}) ==
        "--set seed: given twice; keep one of '1' and '2'");
}

TEST_CASE("a key of an earlier version is refused with its new name, also where it would be taken away") {
  const std::string now =
      "is called physics.contact.viscosity now: at the slip speeds of cells it is a damper, and not Coulomb's "
      "friction; write the new key, with the value as it is";
  for (const char* change : {"physics.contact.friction=0.3", "physics.contact.friction=null"})
    CHECK(complaints(small, {parseOverride(change)}) == "--set physics.contact.friction: " + now);
  CHECK(complaints(small, {{"physics.contact.friction", "0", "a.study.yaml:7:14"}}) ==
        "a.study.yaml:7:14: physics.contact.friction: " + now);
}

TEST_CASE("what is no assignment is refused") {
  for (const auto* text : {"", "=", "a", "=1", ".a=1", "a.=1", "a..b=1"})
    CHECK_THROWS_AS(parseOverride(text), InputError);
  CHECK(parseOverride("a.b=c=d").value == "c=d");
}

TEST_CASE("an entry of a list is called by its name, and only where one entry has it") {
  const std::string scene =
      "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(b0|a0)\n  g3(divide|a0)\nstop: {time: 1}\nphysics: {}\n"
      "division: {rules: [{of: [a0, b0], tilt: 5}, {of: b0, share: 0.4}, {of: a0, axis: [1, 0, 0]}]}\n";
  const auto rulesWith = [&](const std::string& change) {
    return read(scene, {parseOverride(change)}).scene.mechanics->division.rules;
  };
  const auto rules = rulesWith("division.rules.a0.share=0.6");
  REQUIRE(rules.size() == 3);
  CHECK(rules[2].share == 0.6);
  CHECK(rules[2].plane);  // what the entry says besides stays
  CHECK(rules[1].share == 0.4);
  CHECK(rulesWith("division.rules.b0={of: b0, share: 0.7}")[1].share == 0.7);
  CHECK(rulesWith("division.rules.b0=null").size() == 2);
  CHECK_THAT(complaints(scene, {parseOverride("division.rules.c0.share=0.6")}),
             Catch::StartsWith("--set division.rules.c0.share: the list division.rules has no entry of this name, or "
                               "several; needs a text that one entry alone has under of or name"));
  CHECK_THAT(complaints(scene, {parseOverride("division.rules.c0=null")}), Catch::Contains("no entry of this name"));
}
