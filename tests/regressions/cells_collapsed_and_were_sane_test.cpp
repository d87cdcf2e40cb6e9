// Cells that adhesion had crushed into clumps of vertices, or that passed through themselves, were reported as "sane
// yes", or their run failed with an unmeasured cause ("it cannot divide"). Now adhesion saturates where vertices crowd,
// so that no cells collapse, and a cell that passes through itself has a check, and a sentence with the cell, the number
// and the key to change.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// Runs cells that never change but for what `scenario` adds, and returns what the run says of itself.
Json runOf(const std::string& scenario, int code) {
  const Launched run =
      runText("morula: 1\nname: s\ndna: |\n  START: a0\n  g1(a0|a0)\n" + scenario, {"--json", "--no-pictures"});
  INFO(run.err);
  CHECK(run.code == code);
  return Json::parse(run.out);
}

/// Returns the messages of failed sanity checks, by the checks' names.
std::map<std::string, std::string> failedOf(const std::string& scenario) {
  std::map<std::string, std::string> failed;
  const Json told = runOf(scenario, 1);
  for (const auto& check : told.at("sanity"))
    if (!check.at("passed")) failed[check.at("check")] = check.at("message");
  return failed;
}

/// The run ends sane, and no cell is pressed as the collapsed ones were: by 46 to 131, and to a volume of 0.29.
void checkNotCollapsed(const Json& told) {
  CHECK(told.at("sane") == true);
  CHECK(told.at("sample").at("mean_pressure") < 8);
  for (const auto& check : told.at("sanity"))
    if (check.at("check") == "sanity adhesion") CHECK(std::stod(check.at("actual").get<std::string>()) <= 1.1);
}

}  // namespace

TEST_CASE("an organism that adheres below the accepted limit does not collapse") {
  checkNotCollapsed(runOf(
      "  g2(divide|a0)\nstop: {time: 2.5}\nphysics: {mesh: {icosphere: 2}, drag: 3, shell: {fill: 0.85}, contact: "
      "{adhesion: 2}}\n",
      0));
}

TEST_CASE("two flattened cells that adhere do not collapse onto each other") {
  checkNotCollapsed(
      runOf("stop: {time: 1}\ncells: [{at: [-0.62, 0, 0], stretch: [0.6, 1.3, 1.3]}, {at: [0.62, 0, 0], stretch: "
            "[0.6, 1.3, 1.3]}]\nphysics: {mesh: {icosphere: 3}, drag: 3, contact: {adhesion: 2}}\n",
            0));
}

TEST_CASE("a cell that passes through itself is not sane") {
  auto failed = failedOf(
      "stop: {time: 10}\ncells: [{at: [0, 0, 0], stretch: [1.5, 0.7, 0.5]}]\nphysics: {mesh: {icosphere: 3}, drag: "
      "1, shell: {ellipsoid: [1.6, 0.8, 0.6]}}\n");
  CHECK_THAT(failed["sanity self-overlap"], ContainsSubstring("the egg passes through itself"));
}
