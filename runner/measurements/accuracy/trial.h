#pragma once
// A setting, which accuracy varies, and a trial run with it: its result and its cost.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/comparison_times.h"
#include "accuracy/state_error.h"
#include "contacts/parameters.h"
#include "physics/parameters.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

namespace morula {

/// A cheaper cell model than the scene's own.
struct OtherModel {
  CellModel model = CellModel::sphere;
  ShapeMatchingParameters matched;  // only for shape matching
};

/// Returns the models that leave out a part of the given model.
std::vector<CellModel> cheaperThan(CellModel model);

/// Returns the shape matching that moves like the shell near its lengths and volume at rest:
///
///   k = (k_s ΣL² + 3 k_p + 6 P_0 V) / I              it breathes as fast, x → (1 + ε) x
///   (1 − β) k = 2/5 k_s ΣL² / I,  κ = 2/5 k_d ΣL² / I  it swings as fast at constant volume, and as damped
///
/// with the edges L, the volume V and I = Σ m_p |x|² of the egg, whose vertices lie about the origin. The 2/5
/// is the mean over all directions in which a cell is pulled long: of (e·E e)² for an edge's direction e,
/// 1/5, over |E x|²/|x|², 1/2, with E = diag(1, −½, −½).
ShapeMatchingParameters matchShell(const PhysicsParameters& shell, const Mesh& egg);

struct Setting {
  Integrator integrator = Integrator::velocityVerlet;
  double timeStep = 0;
  Precision precision = Precision::binary64;
  std::optional<std::uint64_t> level;     // level of the icosphere; absent: the scene's mesh comes from a file
  std::optional<ContactLaw> law;          // absent: cells cannot touch
  std::optional<std::uint64_t> substeps;  // sub-steps of XPBD; absent: 1
  std::optional<OtherModel> model;        // absent: the scene's
  bool automatic = false;                 // true: the scene chooses its time steps, of which timeStep is the least
  double autoShare = 1;                   // share of the chosen steps, if `automatic`
  std::optional<double> coarsen;          // [length] physics.mesh.coarsen; absent: the scene's
};

/// Returns the scenario's own setting with another time step.
Setting settingOf(const Scenario& scenario, double timeStep);
/// Returns the scenario's own setting. `minTimeStep`: its shortest step.
Setting settingAsItIs(const Scenario& scenario, double minTimeStep);

/// Returns the change for --set of the time step: "physics.time_step=0.5", "physics.time_step.auto=0.5".
std::string timeStepChange(const Setting& setting);

/// Returns all changes for --set, "path=value", that give any scenario of the scene this setting.
std::vector<std::string> changesFor(const Setting& setting);

/// Names the common settings of a series of runs with different time steps: "rk4, icosphere 2, single". Settings equal
/// to those of `usual` are left out, except for the integrator.
std::string seriesName(const Setting& setting, const Setting& usual);

/// Reads the scenario with further changes.
using ReadScenario = std::function<Scenario(const std::vector<std::string>& changes)>;

/// The outcome of a run: its end and its cost.
struct Outcome {
  Setting setting;
  std::string failure;  // "" if it ran to the end
  // Cost of the steps alone
  double cpuSeconds = 0;  // median of the rounds
  std::uint64_t steps = 0, forceEvaluations = 0, vertexSteps = 0;
};

struct Trial : Outcome {
  std::vector<Shapes> shapes;      // at the requested times that the run reached
  std::vector<LineageEntry> born;  // the whole lineage
  std::vector<DivisionRecord> divisions;
};

/// Runs a setting `rounds` times, with equal results, through the times [time], rising multiples of its step. `failure`
/// tells if it fails, does not reach the end, or takes more CPU time than `maxSeconds` [s].
Trial runTrial(const ReadScenario& read, const Setting& setting, const std::vector<double>& times,
               const Execution& execution, int rounds, double maxSeconds = INFINITY);

/// The horizon of chaos of a scene.
struct Horizon {
  double end = 0;       // [time] end of meaningful comparisons: the scene's end, or the growth of chaos
  double rounding = 0;  // [length] growth of one unit in the last place by `end`
  bool parted = false;  // true: chaos sets `end`
  double minTimeStep = 0, maxTimeStep = 0;  // [time] steps of the scene's own settings
  int vertices = 0;                         // living ones at `end`
  std::vector<SceneEvent> events = {};      // up to `end`
};

/// Runs the scene and a twin in which x of one vertex is moved by one unit in the last place. Stops when the difference
/// has grown by `amplification`, as errors of time steps would, or at `latest`. Throws NumericalError.
Horizon findHorizon(const Scene& scene, const Execution& execution, std::optional<double> latest, double amplification);

}  // namespace morula
