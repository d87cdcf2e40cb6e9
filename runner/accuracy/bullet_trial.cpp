#include "accuracy/bullet_trial.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/error.h"
#include "base/number_text.h"
#include "baseline/worker.h"
#include "bench/statistics.h"
#include "mesh/measures.h"
#include "scenario/bullet_fit.h"

namespace morula {

bool areMultiples(const std::vector<double>& times, double timeStep) {
  for (const double time : times)
    if (time / timeStep != std::floor(time / timeStep)) return false;
  return true;
}
namespace {

/// Bullet's bodies as shapes; `world`: the scene at its start, with the same cells.
Shapes shapesOf(const World& world, const std::vector<Body>& cells, double time) {
  Shapes shapes{time, {}};
  const Mesh& egg = world.bodies->mesh.mesh;
  for (std::size_t i = 0; i < cells.size(); ++i)
    shapes.cells.push_back({world.cells.path[i],
                            {cells[i].position, egg.faces},
                            measureCentroid(cells[i].position),
                            measureVolume(cells[i].position, egg.faces)});
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
                   setting.margin * b.parameters.cell.radius};
  for (const int slot : b.slots) request.scene.cells.push_back(takeBody(b, slot));
  for (const double time : times) request.reports.push_back(static_cast<int>(time / setting.timeStep));
  request.steps = request.reports.back();
  return request;
}

}  // namespace

std::string seriesName(const BulletSetting& s, bool touching) {
  return fmt::format("bullet {}{}", name(s.baseline),
                     touching ? ", margin " + numberText(s.margin) : std::string());
}

std::vector<BulletSetting> bulletSettings(const Scenario& scenario, double longest, int halvings,
                                          const std::vector<double>& times) {
  std::vector<BulletSetting> list;
  if (!bulletIsAvailable()) return list;
  const bool touching = scenario.scene.mechanics->contact && scenario.scene.cells.size() > 1;
  for (const Baseline baseline : {Baseline::b1, Baseline::b2, Baseline::b3}) {
    if (!scenario::unfitForBullet(scenario, baseline).empty()) continue;
    for (const double margin : touching ? std::vector<double>{0.01, 0.0025} : std::vector<double>{0.01})
      for (int i = -bulletDoublings; i <= halvings; ++i)
        if (const double timeStep = std::ldexp(longest, -i); areMultiples(times, timeStep))
          list.push_back({baseline, timeStep, margin});
  }
  return list;
}

Trial runBulletTrial(const Scenario& scenario, const BulletSetting& setting, const std::vector<double>& times,
                     const Execution& execution, int rounds, const std::string& program) {
  const World world = makeWorld(scenario.scene, execution);
  const BulletRequest request = requestOf(world, setting, times);
  Trial trial;
  trial.setting = settingOf(scenario, setting.timeStep);
  trial.setting.integrator = Integrator::symplecticEuler;  // B1's and B2's; B3's is of first order too
  std::vector<double> seconds;
  for (int round = 0; round < rounds; ++round) {
    BulletResult result;
    try {
      result = runInBullet(request, program);
    } catch (const std::exception& error) {  // no answer, or none that can be read
      trial.failure = error.what();
      break;
    }
    seconds.push_back(std::accumulate(result.stepSeconds.begin(), result.stepSeconds.end(), 0.0));
    trial.shapes = {shapesOf(world, request.scene.cells, 0)};
    for (std::size_t i = 0; i < times.size(); ++i)
      trial.shapes.push_back(shapesOf(world, result.reports[i], times[i]));
  }
  trial.born = world.lineage.entries;
  if (!seconds.empty()) trial.cpuSeconds = median(seconds);
  trial.steps = trial.forceEvaluations = static_cast<std::uint64_t>(request.steps);
  trial.vertexSteps = trial.steps * static_cast<std::uint64_t>(world.bodies->livingVertices);
  // What has blown up stays finite in Bullet, or is no number: neither is a solution.
  for (const Shapes& shapes : trial.shapes)
    for (const ComparedCell& cell : shapes.cells)
      if (!(cell.volume > 0 && norm(cell.centroid) < 1e9) && trial.failure.empty())
        trial.failure = "a cell is inside out or no number by time " + numberText(shapes.time);
  return trial;
}

}  // namespace morula
