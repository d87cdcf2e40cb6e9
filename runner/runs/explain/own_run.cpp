#include "base/error.h"
#include "explain/run_source.h"
#include "loop/simulate.h"
#include "simulation/world.h"
#include "system/signals.h"

namespace morula {

OwnRun::OwnRun(std::string name, std::function<World()> make, std::function<void(World&)> advance,
               std::function<void(const World&)> watch)
    : name_(std::move(name)), make_(std::move(make)), advance_(std::move(advance)), watch_(std::move(watch)) {}

OwnRun::~OwnRun() = default;

bool OwnRun::goTo(std::uint64_t step) {
  if (!world_ || world_->clock.step > step) {
    world_ = std::make_unique<World>(make_());
    failure_.clear();
  }
  while (world_->clock.step < step) {
    if (!failure_.empty() || finished(*world_)) return false;
    if (watch_) watch_(*world_);
    try {
      advance_(*world_);
    } catch (const NumericalError& error) {
      if (error.want != Want::nothing) throw;  // it says nothing of where runs part
      failure_ = error.what();
    }
  }
  return true;
}

bool OwnRun::addLink(HashTrace& trace) {
  const auto before = trace.links.empty() ? std::nullopt : std::optional(trace.links.back().hash);
  try {
    trace.links.push_back(nextLink(before, *world_));
  } catch (const NumericalError& error) { failure_ = error.what(); }
  return failure_.empty();
}

HashTrace OwnRun::hashTrace(std::uint64_t from, std::uint64_t to, std::uint64_t every) {
  HashTrace t;
  for (std::uint64_t step = from; step <= to; step += every) {
    if (!goTo(step)) break;
    if (!failure_.empty()) break;
    if (!addLink(t)) break;
  }
  // Its last state, too, wherever it lies.
  if (failure_.empty() && world_->clock.step >= from && (t.links.empty() || t.links.back().step < world_->clock.step))
    addLink(t);
  t.lastStep = world_->clock.step;
  t.failure = failure_;
  return t;
}

std::unique_ptr<World> OwnRun::stateAt(std::uint64_t step) {
  goTo(step);
  return std::move(world_);  // the next question starts anew
}

OwnRun scenarioRun(const Scenario& scenario, const Execution& how, const std::string& called) {
  return {called + ", " + std::string(name(how.isa)) + ", threads " + std::to_string(how.threads),
          [&scenario, how] { return makeScenarioWorld(scenario, how); }, [](World& w) { step(w); },
          [](const World&) { stopAtSignal(); }};
}

}  // namespace morula
