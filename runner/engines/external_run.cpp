#include "engines/external_run.h"

#include <limits>

#include "base/error.h"
#include "check/invariants.h"
#include "engines/bullet_run.h"
#include "engines/messages.h"
#include "simulation/measures.h"

namespace morula {

namespace {

/// Of every run that its cells be cells: volumes above 0 and places that are numbers. Bullet goes on with
/// anything.
CheckParameters leastDemands() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CheckParameters check;
  check.volume = Bounds{std::numeric_limits<double>::denorm_min(), infinity};
  check.extent = infinity;
  return check;
}

struct OwnSteps {
  World state;
  const World& world() const { return state; }
  void step() { morula::step(state); }
};

/// `run` has world() and step().
template <class Run>
void goThrough(Run& run, const Scenario& scenario, ExternalRun& answer, const OnStep& onStep) {
  Invariants demands(scenario.check), least(leastDemands());
  Recorder recorder({scenario.record.every, {}});
  const auto observe = [&] {
    demands.observe(run.world());
    least.observe(run.world());
    recorder.observe(run.world());
    return least.holdSoFar();
  };
  bool holds = observe();
  while (holds && !finished(run.world())) {
    run.step();
    answer.step = run.world().clock.step;
    holds = observe();
    onStep(answer.step);
  }
  answer.results = holds ? demands.results(run.world()) : least.watched();
  answer.end = holds ? ExternalRun::End::done : ExternalRun::End::broken;
  answer.volumes = least.volumes();
  answer.samples = recorder.samples();
  if (!holds) return;
  if (answer.samples.empty() || answer.samples.back().world.time != run.world().clock.time)
    answer.samples.push_back({measureWorld(run.world()), measureCells(run.world()), {}});
  for (const CellPath& path : run.world().cells.path)
    answer.shapes.push_back(cellVertices(run.world(), path));
}

}  // namespace

const char* name(Engine engine) {
  constexpr const char* names[] = {"thesis", "b1", "b2", "b3"};
  return names[static_cast<int>(engine)];
}

Engine engineOf(Baseline baseline) {
  return static_cast<Engine>(static_cast<int>(baseline) + static_cast<int>(Engine::b1));
}

Baseline baselineOf(Engine engine) {
  return static_cast<Baseline>(static_cast<int>(engine) - static_cast<int>(Engine::b1));
}

ExternalRun runHere(const Json& json, const OnStep& onStep) {
  ExternalRun answer;
  try {
    const Scenario scenario = scenarioFrom(json);
    const ExternalQuestion question = externalQuestionFrom(json);
    if (question.engine == Engine::thesis) {
      OwnSteps run{makeScenarioWorld(scenario, {})};
      goThrough(run, scenario, answer, onStep);
    } else {
      BulletRun run(scenario, baselineOf(question.engine), question.margin, question.integrator);
      goThrough(run, scenario, answer, onStep);
    }
  } catch (const NumericalError& error) {
    answer.end = ExternalRun::End::stopped;
    answer.why = error.what();
  } catch (const InputError& error) {
    answer.end = ExternalRun::End::refused;
    answer.why = error.what();
  }
  return answer;
}

}  // namespace morula
