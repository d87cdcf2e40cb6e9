#include "explain/scenario_run.h"

#include "system/signals.h"

namespace morula {

void stopAtSignal() {
  if (const int signal = SignalWatch::caught()) throw Interrupted{signal};
}

OwnRun scenarioRun(const Scenario& scenario, const Execution& how) {
  return {"this program, " + std::string(name(how.isa)) + ", threads " + std::to_string(how.threads),
          [&scenario, how] { return makeScenarioWorld(scenario, how); }, [](World& w) { step(w); },
          [](const World&) { stopAtSignal(); }};
}

}  // namespace morula
