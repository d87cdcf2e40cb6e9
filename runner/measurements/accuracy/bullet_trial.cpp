#include "accuracy/bullet_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "base/error.h"
#include "base/number_text.h"
#include "engines/engine_worker.h"
#include "scenario/bullet_fit.h"
#include "system/clock.h"

namespace morula {
namespace {

/// Returns Bullet's bodies as shapes. `world`: the scene at its start, with the same cells.
Shapes shapesOf(const World& world, const std::vector<Body>& cells, double time) {
  Shapes shapes{time, {}};
  const Mesh& egg = world.bodies->mesh.mesh;
  for (std::size_t i = 0; i < cells.size(); ++i)
    shapes.cells.push_back(comparedCell(world.cells.path[i], {cells[i].position, egg.faces}));
  return shapes;
}

BulletRequest requestOf(const World& world, const BulletSetting& setting, const std::vector<double>& times) {
  const Bodies& b = *world.bodies;
  BulletRequest request;
  request.scene = {setting.baseline,
                   b.mesh.mesh,
                   b.parameters,
                   {},
                   setting.timeStep,
                   world.contacts.has_value(),
                   setting.margin * b.parameters.cell.radius,
                   setting.iterations};
  request.scene.physics.integrator = Integrator::velocityVerlet;
  for (const int slot : b.slots) request.scene.cells.push_back(takeBody(b, slot));
  for (const double time : times) request.reports.push_back(static_cast<int>(std::lround(time / setting.timeStep)));
  request.steps = request.reports.back();
  return request;
}

/// Runs a trial in Bullet like runTrial, in a separate process. Its cost is the CPU time of Bullet's steps alone.
Trial runBulletTrial(const Scenario& scenario, const BulletSetting& setting, const BulletSearch& search, int rounds) {
  const std::vector<double>& times = search.times;
  const World world = makeWorld(scenario.scene, search.execution);
  const BulletRequest request = requestOf(world, setting, times);
  Trial trial;
  trial.setting = settingOf(scenario, setting.timeStep);
  // symplecticEuler stands for first order: B2's links see places half a step ahead, and B3 is implicit.
  trial.setting.integrator =
      setting.baseline == Baseline::b1 ? Integrator::velocityVerlet : Integrator::symplecticEuler;
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    BulletResult result;
    try {
      result = runInBullet(request, search.program);
    } catch (const std::exception& error) {  // no answer, or an unreadable one
      trial.failure = error.what();
      break;
    }
    seconds.push_back(std::accumulate(result.stepSeconds.begin(), result.stepSeconds.end(), 0.0));
    trial.shapes = {shapesOf(world, request.scene.cells, 0)};
    for (std::size_t i = 0; i < times.size(); ++i) trial.shapes.push_back(shapesOf(world, result.reports[i], times[i]));
  }
  trial.born = world.lineage.entries;
  if (!seconds.empty()) trial.cpuSeconds = median(seconds);
  trial.steps = trial.forceEvaluations = static_cast<std::uint64_t>(request.steps);
  trial.vertexSteps = trial.steps * static_cast<std::uint64_t>(world.bodies->livingVertices);
  // A world that has diverged stays finite in Bullet or turns into NaN. Neither is a solution.
  for (const Shapes& shapes : trial.shapes)
    for (const ComparedCell& cell : shapes.cells)
      if (!(cell.volume > 0 && norm(cell.centroid) < 1e9) && trial.failure.empty())
        trial.failure = "a cell is inside out or not finite by time " + numberText(shapes.time);
  return trial;
}

bool isSameChoice(const BulletSetting& a, const BulletSetting& b) {
  return a.margin == b.margin && a.iterations == b.iterations;
}

/// Returns the choices of a baseline that deserve shorter steps.
std::vector<BulletSetting> bestChoices(const std::vector<BulletSetting>& choices,
                                       const std::vector<BulletTrial>& trials,
                                       const std::function<std::optional<double>(const Trial&)>& errorOf) {
  std::vector<std::optional<double>> errors;
  std::vector<double> seconds;
  for (const BulletTrial& t : trials) errors.push_back(errorOf(t.trial)), seconds.push_back(t.trial.cpuSeconds);
  const auto best = unbeaten(errors, seconds);
  std::vector<BulletSetting> list;
  for (const BulletSetting& c : choices)
    for (std::size_t i = 0; i < trials.size(); ++i)
      if (best[i] && isSameChoice(trials[i].setting, c)) {
        list.push_back(c);
        break;
      }
  return list.empty() ? choices : list;  // no choice has reached the end, but shorter steps may
}

}  // namespace

bool areMultiples(const std::vector<double>& times, double timeStep) {
  return std::ranges::all_of(times, [&](double time) { return time / timeStep == std::floor(time / timeStep); });
}

std::string seriesName(const BulletSetting& s, bool touching) {
  std::string text = fmt::format("bullet {}", name(s.baseline));
  if (touching) text += ", margin " + numberText(s.margin);
  if (s.iterations > 1) text += fmt::format(", {} iterations", s.iterations);
  return text;
}

std::vector<BulletSetting> bulletChoices(Baseline baseline, bool touching) {
  const bool iterates = baseline == Baseline::b2 || (baseline == Baseline::b1 && touching);
  std::vector<BulletSetting> choices;
  for (const double margin : touching ? std::vector{0.02, 0.01, 0.005, 0.0025} : std::vector{0.01})
    for (int iterations = 1; iterations <= (iterates ? 4 : 1); ++iterations)
      choices.push_back({baseline, 0, margin, iterations});
  return choices;
}

std::vector<double> bulletTimeSteps(double longest, double longestStable, int halvings,
                                    const std::vector<double>& times) {
  std::vector<double> steps;
  for (int i = -bulletDoublings; i <= halvings; ++i)
    if (const double step = std::ldexp(longest, -i); areMultiples(times, step)) steps.push_back(step);
  if (longestStable > longest) steps.push_back(longestStable);
  std::sort(steps.rbegin(), steps.rend());
  for (double& step : steps) step = static_cast<float>(step);
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

std::vector<bool> unbeaten(const std::vector<std::optional<double>>& errors, const std::vector<double>& seconds) {
  std::vector<bool> best;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    bool beaten = !errors[i];
    for (std::size_t j = 0; j < errors.size() && !beaten; ++j)
      beaten = j != i && errors[j] && *errors[j] <= *errors[i] && seconds[j] < seconds[i];
    best.push_back(!beaten);
  }
  return best;
}

std::vector<BulletTrial> tryBullet(const Scenario& scenario, const BulletSearch& search,
                                   const std::function<std::optional<double>(const Trial&)>& errorOf,
                                   const std::function<void(const std::string&)>& tell) {
  std::vector<BulletTrial> list;
  if (!bulletIsAvailable()) return list;
  const bool touching = scenario.scene.mechanics->contact && scenario.scene.cells.size() > 1;
  const auto steps = bulletTimeSteps(search.longest, search.longestStable, search.halvings, search.times);
  for (const Baseline baseline : {Baseline::b1, Baseline::b2, Baseline::b3}) {
    if (!scenario::bulletIncompatibilities(scenario, baseline).empty()) continue;
    std::vector<BulletTrial> trials;
    const auto go = [&](BulletSetting setting, double step, int rounds) {
      setting.timeStep = step;
      const std::string series = seriesName(setting, touching);
      tell(fmt::format("{}, time step {}", series, numberText(step)));
      trials.push_back({setting, series, runBulletTrial(scenario, setting, search, rounds)});
    };
    std::vector<BulletSetting> choices = bulletChoices(baseline, touching);
    if (choices.size() > 1) {
      for (const BulletSetting& choice : choices)
        for (const double step : steps)
          if (step >= search.longest) go(choice, step, 1);
      choices = bestChoices(choices, trials, errorOf);
      // The best choices are measured again, in as many rounds as Morula's settings.
      std::erase_if(trials, [&](const BulletTrial& t) {
        return std::ranges::any_of(choices, [&](const BulletSetting& c) { return isSameChoice(c, t.setting); });
      });
    }
    for (const BulletSetting& choice : choices)
      for (const double step : steps) go(choice, step, search.rounds);
    std::move(trials.begin(), trials.end(), std::back_inserter(list));
  }
  return list;
}

}  // namespace morula
