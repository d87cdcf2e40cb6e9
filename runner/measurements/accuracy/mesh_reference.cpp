// The reference over meshes: the affordable levels, and their time steps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/converged_reference.h"
#include "base/number_text.h"

namespace morula {
namespace {

constexpr std::uint64_t finestLevel = 4;    // finest icosphere of scenarios
constexpr std::uint64_t coarsestLevel = 1;  // level 0 has twelve vertices, too few for a sphere
constexpr double share = 0.1;               // max share of the mesh's error that time steps may add
constexpr int maxHalvings = 5;

/// Runs on other levels, and their costs.
class Study {
 public:
  Study(const AccuracyRuns& runs, const Scenario& scenario, const Trial& own)
      : runs_(runs), scenario_(scenario), own_(own), level_(*runs.usual.level) {
    // XPBD bears any step; the steps of its scenarios are too long for other integrators.
    const double usual = runs.usual.timeStep / 2;
    step_ = runs.usual.integrator == Integrator::xpbd ? std::min(usual, 2 * own.setting.timeStep) : usual;
  }

  MeshStudy run(const std::vector<std::uint64_t>& furtherLevels) {
    std::string limit;
    const bool first = addFiner(limit);
    if (first && limit.empty() && level_ + 2 <= finestLevel) addFinest(limit);
    std::uint64_t finest = level_;
    while (at(finest + 1)) ++finest;
    // Three neighbouring levels show the order; coarser ones stand in for missing finer ones.
    for (std::uint64_t l = level_; l-- > coarsestLevel && finest - l <= 2;) addCoarser(l);
    for (const std::uint64_t l : furtherLevels)
      if (!at(l)) addCoarser(l);
    std::vector<SolvedMesh> meshes;
    for (std::uint64_t l = finest + 1; l-- > 0 && meshes.size() < 3 && at(l);)
      meshes.insert(meshes.begin(), {l, at(l)});
    if (meshes.size() < 2) result_.error.unknown = limit.empty() ? "there is no other mesh" : limit;
    else result_.error = estimateMeshError(meshes, level_, runs_.eggRadius, runs_.events);
    result_.error.own = level_;
    result_.error.limit = limit;
    result_.error.timeError = timeError_;
    result_.error.cpuSeconds = spent_;
    return std::move(result_);
  }

 private:
  const Trial* at(std::uint64_t level) const {
    if (level == level_) return &own_;
    const auto found = result_.solved.find(level);
    return found == result_.solved.end() ? nullptr : &found->second;
  }

  Setting settingAt(std::uint64_t level, double timeStep) const {
    Setting s = convergent(runs_.usual, Integrator::velocityVerlet);
    s.level = level;
    s.timeStep = timeStep;
    if (const auto coarsen = scenario_.scene.mechanics->physics.coarsen)
      s.coarsen = std::ldexp(*coarsen, static_cast<int>(level_) - static_cast<int>(level));
    return s;
  }

  /// Predicts the CPU time of a run [s], from the reference's time for each vertex and force evaluation.
  double predictSeconds(std::uint64_t level, double timeStep) const {
    const auto vertices = [](std::uint64_t l) { return 10 * std::exp2(2.0 * double(l)) + 2; };
    const double perStep = own_.steps > 0 ? own_.cpuSeconds / double(own_.forceEvaluations) : 0;
    return perStep * (vertices(level) / vertices(level_)) * (runs_.times.back() / timeStep);
  }

  /// Solves the scene on a level. `timeStep` is halved while it fails. Fails also if a run is not affordable.
  Trial solve(std::uint64_t level, double& timeStep) {
    Trial t;
    for (int i = 0; i <= maxHalvings; ++i, timeStep /= 2) {
      const double seconds = predictSeconds(level, timeStep), rest = runs_.options.budget - spent_;
      if (!(seconds <= rest)) {
        t.failure = fmt::format("icosphere {} takes about {} s of CPU time, and {} s of {} s are left (--budget)",
                                level, numberText(seconds, 2), numberText(std::max(0.0, rest), 2),
                                numberText(runs_.options.budget, 4));
        return t;
      }
      runs_.options.tell(fmt::format("icosphere {}, time step {}", level, numberText(timeStep)));
      t = runs_.trial(settingAt(level, timeStep), 1, rest);
      spent_ += t.cpuSeconds;
      if (t.failure.empty()) return t;
    }
    t.failure = fmt::format("icosphere {} does not run: {}", level, t.failure);
    return t;
  }

  double largestDistance(const Trial& a, const Trial& b) const {
    return compareRuns(a, b, runs_.eggRadius).worst.largest();
  }

  /// Adds one finer level, in steps that are halved until they change little beside the mesh's error.
  bool addFiner(std::string& limit) {
    if (level_ + 1 > finestLevel) {
      limit = "there is no finer icosphere";
      return false;
    }
    double timeStep = step_ / 2;
    Trial coarse = solve(level_ + 1, timeStep);
    fine_ = timeStep;
    if (!coarse.failure.empty()) {  // it is compared as far as it ran
      limit = coarse.failure;
      const bool came = coarse.shapes.size() > 1;
      if (came) result_.solved[level_ + 1] = std::move(coarse);
      return came;
    }
    for (int i = 0; i < maxHalvings; ++i) {
      timeStep = fine_ / 2;
      Trial fine = solve(level_ + 1, timeStep);
      if (!fine.failure.empty()) break;
      const double moved = largestDistance(coarse, fine);
      const bool falls = i == 0 || moved < 0.7 * timeError_;
      timeError_ = i == 0 ? moved : std::min(moved, timeError_);
      fine_ = timeStep;
      coarse = std::move(fine);
      if (!falls || moved <= share * largestDistance(own_, coarse)) break;
    }
    result_.solved[level_ + 1] = std::move(coarse);
    return true;
  }

  void addFinest(std::string& limit) {
    double timeStep = fine_ / 2;
    Trial t = solve(level_ + 2, timeStep);
    if (t.failure.empty()) result_.solved[level_ + 2] = std::move(t);
    else limit = t.failure;
  }

  /// Adds a level, if affordable, with the reference's steps, halved for each finer level.
  void addCoarser(std::uint64_t level) {
    Setting s = own_.setting;
    s.level = level;
    s.coarsen = settingAt(level, s.timeStep).coarsen;
    if (level > level_) s.timeStep = std::ldexp(s.timeStep, static_cast<int>(level_) - static_cast<int>(level));
    if (!(predictSeconds(level, s.timeStep) <= runs_.options.budget - spent_)) return;
    runs_.options.tell(fmt::format("icosphere {}, time step {}", level, numberText(s.timeStep)));
    Trial t = runs_.trial(s, 1);
    spent_ += t.cpuSeconds;
    if (t.failure.empty()) result_.solved[level] = std::move(t);
  }

  const AccuracyRuns& runs_;
  const Scenario& scenario_;
  const Trial& own_;
  const std::uint64_t level_;
  double step_ = 0, fine_ = 0;        // [time]
  double timeError_ = 0, spent_ = 0;  // [s]
  MeshStudy result_;
};

}  // namespace

MeshStudy studyMeshes(const AccuracyRuns& runs, const Scenario& scenario, const Trial& own,
                      const std::vector<std::uint64_t>& furtherLevels) {
  MeshStudy none;
  if (!kindOf(scenario.scene.mechanics->physics.cell.model).hasMesh) {
    none.error.none = true;
    return none;
  }
  if (!runs.usual.level) {
    none.error.unknown = "the mesh comes from a file, and there is no finer one of the same shape";
    return none;
  }
  return Study(runs, scenario, own).run(furtherLevels);
}

}  // namespace morula
