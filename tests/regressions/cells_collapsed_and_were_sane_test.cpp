// Cells that adhesion had crushed into clumps of vertices, or that passed through themselves, were reported as "sane
// yes", or their run failed with an unmeasured cause ("it cannot divide"). Now each fault has a check, and a sentence
// with the cell, the number and the key to change.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// Returns the messages of failed sanity checks, by the checks' names.
std::map<std::string, std::string> failedOf(const std::string& scenario) {
  const Launched run =
      runText("morula: 1\nname: s\ndna: |\n  START: a0\n  g1(a0|a0)\n" + scenario, {"--json", "--no-pictures"});
  INFO(run.err);
  CHECK(run.code == 1);
  std::map<std::string, std::string> failed;
  const Json told = Json::parse(run.out);
  for (const auto& check : told.at("sanity"))
    if (!check.at("passed")) failed[check.at("check")] = check.at("message");
  return failed;
}

}  // namespace

TEST_CASE("an organism that its adhesion has collapsed is not sane") {
  auto failed = failedOf(
      "  g2(divide|a0)\nstop: {time: 2.5}\nphysics: {mesh: {icosphere: 2}, drag: 3, shell: {fill: 0.85}, contact: "
      "{adhesion: 2}}\n");
  CHECK_THAT(failed["sanity adhesion"],
             ContainsSubstring("times the energy that its whole surface holds where it touches others; "
                               "fine is at most 2; lower physics.contact.adhesion, which is 2"));
  CHECK_THAT(failed["sanity folded"], ContainsSubstring("is folded over by more than 90° at 0.9"));
}

TEST_CASE("two flattened cells that collapse onto each other are not sane") {
  auto failed = failedOf(
      "stop: {time: 1}\ncells: [{at: [-0.62, 0, 0], stretch: [0.6, 1.3, 1.3]}, {at: [0.62, 0, 0], stretch: "
      "[0.6, 1.3, 1.3]}]\nphysics: {mesh: {icosphere: 3}, drag: 3, contact: {adhesion: 2}}\n");
  CHECK_THAT(failed["sanity adhesion"],
             ContainsSubstring("cell ") && ContainsSubstring("lower physics.contact.adhesion"));
}

TEST_CASE("a cell that passes through itself is not sane") {
  auto failed = failedOf(
      "stop: {time: 10}\ncells: [{at: [0, 0, 0], stretch: [1.5, 0.7, 0.5]}]\nphysics: {mesh: {icosphere: 3}, drag: "
      "1, shell: {ellipsoid: [1.6, 0.8, 0.6]}}\n");
  CHECK_THAT(failed["sanity self-overlap"], ContainsSubstring("the egg passes through itself"));
}
