#include "engines/external_run.h"

#include <limits>

#include "base/error.h"
#include "check/invariants.h"
#include "engines/bullet_run.h"
#include "engines/engine_worker.h"
#include "loop/run.h"
#include "loop/scenario_run.h"
#include "observation/measures.h"

namespace morula {
namespace {

/// Returns the conditions on every run: positive volumes, and places that are numbers. Bullet itself would go on.
CheckParameters minDemands() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CheckParameters check;
  check.volume = Bounds{std::numeric_limits<double>::denorm_min(), infinity};
  check.extent = infinity;
  return check;
}

struct OwnSteps {
  Run run;
  const World& world() const { return run.world(); }
  void step() { run.advance(1); }
};

/// Keeps the shapes at the requested times.
class FrameKeeper {
 public:
  FrameKeeper(const std::vector<double>& times, std::vector<ExternalFrame>& frames) : times_(times), frames_(frames) {}
  void observe(const World& world) {
    if (next_ == times_.size() || world.clock.time < times_[next_]) return;
    while (next_ < times_.size() && world.clock.time >= times_[next_]) ++next_;
    ExternalFrame frame{world.clock.time, world.clock.step, shapesOf(world)};
    for (const auto& shape : frame.shapes) vertices_ += shape.size();
    if (vertices_ <= maxFrameVertices) frames_.push_back(std::move(frame));
  }

 private:
  const std::vector<double>& times_;
  std::vector<ExternalFrame>& frames_;
  std::size_t next_ = 0, vertices_ = 0;
};

/// Runs the scenario to its end; `run` has world() and step().
template <class Run>
void goThrough(Run& run, const Scenario& scenario, const std::vector<double>& frameTimes, ExternalRun& answer,
               const OnStep& onStep) {
  Invariants demands(scenario.check), least(minDemands());
  Recorder recorder({scenario.record.every, {}});
  FrameKeeper keeper(frameTimes, answer.frames);
  const auto observe = [&] {
    demands.observe(run.world());
    least.observe(run.world());
    recorder.observe(run.world());
    keeper.observe(run.world());
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
  answer.shapes = shapesOf(run.world());
}

}  // namespace

Engine engineOf(Baseline baseline) {
  return static_cast<Engine>(static_cast<int>(baseline) + static_cast<int>(Engine::b1));
}

Baseline baselineOf(Engine engine) {
  return static_cast<Baseline>(static_cast<int>(engine) - static_cast<int>(Engine::b1));
}

std::vector<std::vector<Point>> shapesOf(const World& world) {
  std::vector<std::vector<Point>> shapes;
  for (const CellPath& path : world.cells.path) shapes.push_back(cellVertices(world, path));
  return shapes;
}

ExternalRun runHere(const Json& json, const OnStep& onStep) {
  ExternalRun answer;
  try {
    const Scenario scenario = scenarioFrom(json);
    const ExternalQuestion question = externalQuestionFrom(json);
    if (question.engine == Engine::thesis) {
      OwnSteps run{Run(makeScenarioWorld(scenario, {}))};
      goThrough(run, scenario, question.frameTimes, answer, onStep);
    } else {
      BulletRun run(scenario, baselineOf(question.engine), question.margin, question.integrator);
      goThrough(run, scenario, question.frameTimes, answer, onStep);
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
