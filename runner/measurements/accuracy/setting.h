#pragma once
// One way to compute a scene: what accuracy varies.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contacts/parameters.h"
#include "physics/parameters.h"
#include "scenario/scenario.h"

namespace morula {

/// A cheaper cell model than the scene's own.
struct OtherModel {
  CellModel model = CellModel::sphere;
  ShapeMatchingParameters matched;  // of shape matching only
};

struct Setting {
  Integrator integrator = Integrator::velocityVerlet;
  double timeStep = 0;
  Precision precision = Precision::binary64;
  std::optional<std::uint64_t> level;     // of the icosphere; absent: the scene's mesh comes from a file
  std::optional<ContactLaw> law;          // absent: cells cannot touch
  std::optional<std::uint64_t> substeps;  // of XPBD; absent: 1
  std::optional<OtherModel> model;        // absent: the scene's
  bool automatic = false;                 // the scene chooses its time steps; timeStep is the least of them
  double autoShare = 1;                   // of the steps that it would choose, where `automatic`
  std::optional<double> coarsen;          // [length] physics.mesh.coarsen; absent: the scene's
};

/// Of the forces, in each time step: XPBD's sub-steps count.
std::uint64_t evaluationsPerStep(const Setting& setting);

/// The scenario's own way, with another time step.
Setting settingOf(const Scenario& scenario, double timeStep);
/// Just as it is; `leastTimeStep` is the shortest that it takes.
Setting settingAsItIs(const Scenario& scenario, double leastTimeStep);

/// The text after --set for the time step: "physics.time_step=0.5", "physics.time_step.auto=0.5".
std::string timeStepChange(const Setting& setting);

/// "path=value", as --set takes them. All of them: they make any scenario of the scene compute in this way.
std::vector<std::string> changesFor(const Setting& setting);

/// What is the same in a series of runs whose time steps differ: "rk4, icosphere 2, single"; what is as in
/// `usual` is not said, but for the integrator.
std::string seriesName(const Setting& setting, const Setting& usual);

/// Reads the scenario with further changes.
using ReadScenario = std::function<Scenario(const std::vector<std::string>& changes)>;

}  // namespace morula
