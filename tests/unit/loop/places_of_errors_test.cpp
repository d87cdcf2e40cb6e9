// Errors of the simulator name their key, and the runner its line in the scenario.
#include "catch.h"
#include "loop/scenario_run.h"
#include "scenario/scenario.h"

using namespace morula;

namespace {

std::string refusalOf(const std::string& physics, const std::string& more, const std::vector<Override>& changes = {}) {
  const Scenario scenario =
      readScenario("morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics:\n  " + physics + "\n" + more,
                   "two.yaml", "", changes);
  try {
    makeScenarioWorld(scenario, {});
    return "";
  } catch (const InputError& error) { return error.what(); }
}

}  // namespace

TEST_CASE("A time step above a limit is told at its line, with one cell and with several") {
  const std::string step = "time_step: 0.5", mesh = "\n  mesh: {icosphere: 1}";
  CHECK_THAT(refusalOf(step + mesh, ""), Catch::StartsWith("two.yaml:6:14: physics.time_step: 0.5 is above"));
  CHECK_THAT(refusalOf(step + mesh, "cells: [{at: [-2, 0, 0]}, {at: [2, 0, 0]}]\n"),
             Catch::StartsWith("two.yaml:6:14: physics.time_step: cell A: 0.5 is above"));
  CHECK_THAT(refusalOf("mesh: {icosphere: 1}", "", {parseOverride("physics.time_step=0.5")}),
             Catch::StartsWith("--set physics.time_step: 0.5 is above"));
}

TEST_CASE("A key that the scenario does not give is told with the file") {
  CHECK_THAT(refusalOf("integrator: explicit-euler\n  drag: 0", ""),
             Catch::StartsWith("two.yaml:6:15: physics.integrator: explicit-euler is stable with no time step"));
}
