// Properties that hold for each random scene (random_scenes.cpp).
#include "scene_properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>

#include "base/error.h"
#include "check/sanity_check.h"
#include "connections/connections.h"
#include "diagnose/diagnose.h"
#include "loop/simulate.h"
#include "observation/body_measures.h"
#include "observation/energy.h"
#include "observation/measures.h"
#include "own_oracles.h"
#include "scenario/parameter_table.h"
#include "scenes_by_chance.h"
#include "simulation/restore.h"
#include "simulation/settle.h"
#include "state/state_hash.h"

namespace morula::chance {
namespace {

constexpr double maxWork = 4e6;   // max vertices times force evaluations of a run: 0.3 s; longer runs are cut short
constexpr double maxGain = 0.05;  // [1] of the energy, as in check/sanity_check.cpp
constexpr std::uint64_t fewSteps = 40;

/// Measures the gain of energy [force·length] since the last event, in worlds that are closed between events.
class EnergyWatch {
 public:
  void see(const World& world) {
    if (!isClosedBetweenEvents(world)) return;
    const Energy now = measureEnergy(world);
    auto cells = std::pair(world.cells.path, world.cells.state);
    const auto ties = world.connections ? world.connections->history.size() + released(world) : 0;
    if (cells != cells_ || ties != ties_ || !begin_) {
      // Forces of newborn cells are computed only in the next step, so the energy is taken from then on.
      begin_.reset();
      if (cells == cells_ && ties == ties_) {
        begin_ = now.total();
        double atRest = 0;
        for (const int slot : world.bodies->slots)
          atRest += world.bodies->parameters.pressure.outside * measureRestVolume(*world.bodies, slot);
        scale_ = std::max(now.total() - 2 * now.adhesion, 0.01 * atRest);
      }
      cells_ = std::move(cells), ties_ = ties;
    } else if (scale_ > 0) {
      gain = std::max(gain, (now.total() - *begin_) / scale_);
    }
  }
  double gain = 0;

 private:
  static std::size_t released(const World& world) {
    return std::ranges::count_if(world.connections->history, [](const ConnectionRecord& c) { return c.released >= 0; });
  }
  std::optional<double> begin_;
  double scale_ = 0;
  std::pair<std::vector<CellPath>, std::vector<StateId>> cells_;  // the state decides how cells stick
  std::size_t ties_ = 0;
};

double workOf(const World& world, std::uint64_t steps) {
  if (settles(world)) {
    double work = 0;
    for (const SettlingRecord& s : *world.settlings) work += static_cast<double>(s.evaluations);
    return work * world.bodies->livingVertices;
  }
  return static_cast<double>(steps) * world.bodies->livingVertices * (1 + world.stages.furtherDrifts.size()) *
         static_cast<double>(world.bodies->parameters.substeps.value_or(1));
}

Execution ownExecution() { return {.isa = bestIsa(), .threads = 1, .memoryLimit = 4e8}; }

/// Runs to the end, or to `lastStep`.

}  // namespace

std::string groupOf(std::string text) {
  text = text.substr(0, text.find('\n'));
  static const std::vector<std::pair<std::regex, std::string>> without = {
      {std::regex(R"(^[^ ]*:\d+:\d+: )"), ""},
      {std::regex(R"('[^']*')"), "'…'"},
      {std::regex(R"(\b(cell )?(the egg|/?[AB]+)\b)"), "a cell"},
      {std::regex(R"(-?\d+(\.\d+)?(e[+-]?\d+)?)"), "N"}};
  for (const auto& [what, with] : without) text = std::regex_replace(text, what, with);
  return text.substr(0, 110);
}

Course run(const Scenario& scenario, bool diagnoses, std::optional<std::uint64_t> lastStep) {
  Course course;
  try {
    course.world = makeScenarioWorld(scenario, ownExecution());
  } catch (const InputError& e) {
    course.refused = true, course.text = e.what(), course.group = groupOf(e.what());
    return course;
  }
  World& world = *course.world;
  const SanityCheck sanity(world);
  EnergyWatch energy;
  std::uint64_t keepAt = 8;
  double work = 0;
  try {
    energy.see(world);
    while (!finished(world) && work < maxWork && (!lastStep || world.clock.step < *lastStep)) {
      const std::uint64_t before = world.clock.step;
      takeSteps(world, lastStep ? std::min<std::uint64_t>(16, *lastStep - before) : 16);
      if (world.bodies) work = settles(world) ? workOf(world, 0) : work + workOf(world, world.clock.step - before);
      energy.see(world);
      if (world.clock.step >= keepAt || (settles(world) && world.clock.step == 2))
        course.half = saveState(world), keepAt = world.clock.step * 2;
    }
    stateHash(world);
  } catch (const NumericalError& e) {
    course.stopped = true;
    course.text = e.what();
    const auto* body = dynamic_cast<const BodyFailure*>(&e);
    if (body && diagnoses && !settles(world)) course.text = diagnose(world.model, world.execution, *body);
    course.group = groupOf(e.quantity.empty() ? e.what() : e.quantity);
    return course;
  }
  course.gain = energy.gain;
  course.sane = true;
  for (const CheckResult& result : sanity.results(world, scenario.check, true)) {
    if (result.passed && scenario.check.sane) continue;
    if (course.sane) course.text = result.message, course.group = "not sane: " + result.field;
    course.sane = false;
  }
  return course;
}

namespace {

/// Returns the max distance [length] of a copy's vertices from their proper places; infinite if other cells live.
double differenceOf(const World& world, const World& copy, const Turn& turn) {
  if (world.cells.path != copy.cells.path || world.clock.step != copy.clock.step) return INFINITY;
  double most = 0;
  for (const CellPath& cell : world.cells.path) {
    const auto one = cellVertices(world, cell), other = cellVertices(copy, cell);
    for (std::size_t v = 0; v < one.size(); ++v) most = std::max(most, norm(turn.place(one[v]) - other[v]));
  }
  return most;
}

/// Returns true if both worlds have the same divisions. The sign of an axis, and the axis of a round cell, belong to
/// the scene and not to its turn; rounding decides the side of a vertex in the plane. A copy that divides otherwise is
/// another scene from then on.
bool dividedAlike(const World& world, const World& copy, const Turn& turn, double tolerance) {
  if (world.divisions.size() != copy.divisions.size()) return false;
  for (std::size_t i = 0; i < world.divisions.size(); ++i)
    if (!(norm(turn.place(world.divisions[i].axis) - copy.divisions[i].axis) <= tolerance) ||
        !(std::abs(world.divisions[i].share - copy.divisions[i].share) <= tolerance * tolerance))
      return false;
  return true;
}

/// [1] The size of rounding errors that have accumulated for a while.
double jitterOf(const Scene& scene) { return scene.mechanics->physics.precision == Precision::binary32 ? 4e-7 : 1e-12; }

/// Returns a copy moved by rounding errors: the distance between such copies measures how chaotic a scene is.
Scene jittered(Scene scene, std::uint64_t copy) {
  Draw draw(scene.seed + copy);
  const double most = jitterOf(scene) * scene.mechanics->physics.cell.radius;
  for (Point& v : scene.mechanics->mesh.vertices)
    v += Vector{draw.between(-most, most), draw.between(-most, most), draw.between(-most, most)};
  return scene;
}

/// Returns how a copy differs; "" if it does not.
std::string wrongWith(const Turn& turn, const Scenario& scenario, const World& end) {
  // Exact copies are compared at the end, others while rounding is small.
  const std::uint64_t last = turn.isExact ? end.clock.step : std::min(end.clock.step, fewSteps);
  const auto changed = [&](Scene scene) {
    Scenario copy = scenario;
    copy.scene = std::move(scene);
    return run(copy, false, last);
  };
  const Course copy = changed(turned(scenario.scene, turn));
  if (copy.refused) return "is refused: " + copy.text;
  Course own;
  if (!turn.isExact) own = run(scenario, false, last);
  // Returns the allowed distance, by a copy that was moved a little; nothing if this copy stops or divides otherwise.
  const auto boundBy = [&](std::uint64_t number) -> std::optional<double> {
    const Course near = changed(jittered(scenario.scene, number));
    const Turn still{"", [](const Vector& v) { return v; }};
    if (own.stopped || near.stopped || !dividedAlike(*own.world, *near.world, still, 1e-3)) return {};
    return 1e3 * jitterOf(scenario.scene) * end.bodies->parameters.cell.radius +
           100 * differenceOf(*own.world, *near.world, still);
  };
  const std::optional<double> bound = turn.isExact ? 0 : boundBy(0);
  if (!bound) return "";
  const World& world = turn.isExact ? end : *own.world;
  // A copy that divides otherwise is another scene; only divisions of one world alone are wrong.
  const bool alike = dividedAlike(world, *copy.world, turn, turn.isExact ? 0 : 1e-3);
  if (!alike) return world.divisions.empty() != copy.world->divisions.empty() ? "divides otherwise" : "";
  if (copy.stopped) return "stops: " + copy.text;
  const double difference = differenceOf(world, *copy.world, turn);
  if (difference <= *bound) return "";
  // Sticky cells that settle have many states of rest near each other, and one moved copy may reach the same by chance.
  for (std::uint64_t number = 1; !turn.isExact && number < 8; ++number) {
    const std::optional<double> other = boundBy(number);
    if (!other || difference <= *other) return "";
  }
  return fmt::format("is {:.3g} away after {} steps", difference, world.clock.step);
}

std::string wrongAfterResuming(const Scenario& scenario, const Course& course, std::uint64_t seed) {
  if (course.half.empty()) return "";
  Execution other = otherExecution(ownExecution());
  other.threads = seed % 8 == 0 ? 2 : 1;
  World world = makeScenarioWorld(scenario, other);
  restoreState(world, course.half);
  const std::uint64_t from = world.clock.step, end = course.world->clock.step;
  while (world.clock.step < end) takeSteps(world, std::min<std::uint64_t>(7, end - world.clock.step));
  return stateHash(world) == stateHash(*course.world) ? "" : fmt::format("from step {} to {}", from, end);
}

/// Checks that recording does not change results.
std::string wrongWhenRecorded(const Scenario& scenario, const World& end) {
  const Simulation recorded = simulate(scenario, ownExecution(), {.record = recordingOf(scenario, true)});
  if (recorded.end.want != Want::nothing) return "";
  return stateHash(recorded.world) == stateHash(end) ? "" : recorded.end.failure + " and other bits";
}

std::string wrongWithoutBodies(const Scenario& scenario, const World& end) {
  if (!isOfGenesAlone(scenario.scene)) return "";
  Scene scene = scenario.scene;
  scene.mechanics.reset();
  // A run with enough cells ends between the events of one step.
  const auto& enough = scene.stop.cells;
  if (enough && end.cells.path.size() >= *enough) scene.stop = {.cycles = {}, .time = {}, .cells = enough};
  else scene.stop = {.cycles = {}, .time = end.clock.time, .cells = {}};
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  const auto one = familyOf(world), other = familyOf(end);
  if (one == other) return "";
  for (const auto& [path, state] : one)
    if (!other.contains(path)) return fmt::format("cell /{} does not live", path);
    else if (other.at(path) != state) return fmt::format("cell /{} holds {}, not {}", path, other.at(path), state);
  return "more cells live";
}

Course runWithHalfTheStep(const Scenario& scenario, const World& end) {
  Scenario half = scenario;
  PhysicsParameters& p = half.scene.mechanics->physics;
  if (settles(end)) p.quasiStatic.evaluations *= 2;
  else if (p.timeStep) *p.timeStep /= 2;
  else p.autoShare /= 2;
  half.scene.stop.time = end.clock.time;
  return run(half);
}

/// Returns a gain of energy that does not fall with the time step. A gain from the time step's error falls; it may be
/// large just after a division.
std::string gainIn(const Course& course, const Course& half) {
  if (!(course.gain > maxGain && half.sane && half.gain > 0.7 * course.gain)) return "";
  return fmt::format("by {:.3g}, and by {:.3g} with half the step", course.gain, half.gain);
}

}  // namespace

Verdict judge(const std::string& text, std::uint64_t seed, bool diagnoses) {
  Verdict verdict;
  Scenario scenario;
  const auto find = [&](const char* what, std::string more) {
    if (!more.empty() && verdict.find.empty()) verdict.find = what, verdict.more = std::move(more);
  };
  try {
    try {
      scenario = readScene(text);
    } catch (const InputError& e) {
      verdict.course.refused = true, verdict.course.text = e.what(), verdict.course.group = groupOf(e.what());
    }
    if (!verdict.course.refused) verdict.course = run(scenario, diagnoses);
    Course& course = verdict.course;
    static const std::regex placed("^(" + sceneFile + R"(|\S+:\d+:\d+): [^\n]+)");
    if (course.refused && !std::regex_search(course.text, placed)) find("refused without a place", course.text);
    if (course.refused || course.stopped || !course.world->bodies) return verdict;
    verdict.tooLong = !finished(*course.world);
    if (course.sane) find("called sane and is not", ownVerdict(*course.world));
    find("another lineage than without bodies", wrongWithoutBodies(scenario, *course.world));
    find("other bits after resuming", wrongAfterResuming(scenario, course, seed));
    if (!verdict.tooLong) find("other bits when recorded", wrongWhenRecorded(scenario, *course.world));
    if (!course.sane) return verdict;
    const Course half = runWithHalfTheStep(scenario, *course.world);
    if (half.sane && finished(*half.world)) {
      find("wrong with half the step", ownVerdict(*half.world));
      find("another lineage with half the step", wrongWithoutBodies(scenario, *half.world));
    }
    find("gains energy", gainIn(course, half));
    if (!usesSeed(scenario.scene))
      for (const Turn& turn : turns) find(turn.name, wrongWith(turn, scenario, *course.world));
  } catch (const std::exception& e) { find("an exception", e.what()); }
  return verdict;
}

}  // namespace morula::chance
