// A stored run and the same run again have no difference, wherever the last step lies.
#include "catch.h"
#include "explain/explain.h"
#include "explain/run_source.h"
#include "files/folders.h"
#include "loop/simulate.h"

using namespace morula;

TEST_CASE("of every shipped scenario, a run of steps that are no multiple of those hashed is the same as it is again") {
  int compared = 0;
  for (const auto& file : filesBelow("scenarios", ".yaml")) {
    if (file.string().ends_with(".study.yaml")) continue;
    CAPTURE(file.string());
    Scenario scenario = loadScenario(file.string());
    try {
      const double timeStep = makeScenarioWorld(scenario, {}).clock.timeStep;
      scenario.scene.stop = {};
      if (timeStep > 0) scenario.scene.stop.time = 70.5 * timeStep;
      else scenario.scene.stop.cycles = 3;
    } catch (const InputError&) {
      CHECK_FALSE(scenario.check.fails.empty());
      continue;
    }
    const Simulation run = simulate(scenario, Execution{}, {.record = recordingOf(scenario, true)});
    if (run.end.status != RunStatus::done) continue;  // the test is about finished runs
    const auto& chain = run.results.chain;
    REQUIRE(chain.size() > 1);
    StoredRunSource stored("stored", chain, run.end.steps, "");
    OwnRun again = scenarioRun(scenario, {});
    const Explanation found = explain(stored, again, chain[1].step - chain[0].step);
    INFO(found.text);
    CHECK(found.failureClass == FailureClass::none);
    ++compared;
  }
  CHECK(compared > 40);
}
