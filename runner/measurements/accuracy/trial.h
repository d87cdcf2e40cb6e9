#pragma once
// One way to compute a scene, which is what accuracy varies, and one run in it: what it came to, and what it cost.
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/state_error.h"
#include "contacts/parameters.h"
#include "physics/parameters.h"
#include "scenario/scenario.h"
#include "simulation/world.h"

namespace morula {

/// A cheaper cell model than the scene's own.
struct OtherModel {
  CellModel model = CellModel::sphere;
  ShapeMatchingParameters matched;  // of shape matching only
};

/// Returns the models that leave out something that the model has.
std::vector<CellModel> cheaperThan(CellModel model);

/// The shape matching that moves like the shell near its lengths and volume at rest:
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
  std::optional<std::uint64_t> level;     // of the icosphere; absent: the scene's mesh comes from a file
  std::optional<ContactLaw> law;          // absent: cells cannot touch
  std::optional<std::uint64_t> substeps;  // of XPBD; absent: 1
  std::optional<OtherModel> model;        // absent: the scene's
  bool automatic = false;                 // the scene chooses its time steps; timeStep is the least of them
  double autoShare = 1;                   // of the steps that it would choose, where `automatic`
  std::optional<double> coarsen;          // [length] physics.mesh.coarsen; absent: the scene's
};

/// The scenario's own way, with another time step.
Setting settingOf(const Scenario& scenario, double timeStep);
/// Just as it is; `minTimeStep` is the shortest that it takes.
Setting settingAsItIs(const Scenario& scenario, double minTimeStep);

/// The text after --set for the time step: "physics.time_step=0.5", "physics.time_step.auto=0.5".
std::string timeStepChange(const Setting& setting);

/// "path=value", as --set takes them. All of them: they make any scenario of the scene compute in this way.
std::vector<std::string> changesFor(const Setting& setting);

/// Names the common settings of a series of runs whose time steps differ: "rk4, icosphere 2, single". Settings that are
/// as in `usual` are not named, except for the integrator.
std::string seriesName(const Setting& setting, const Setting& usual);

/// Reads the scenario with further changes.
using ReadScenario = std::function<Scenario(const std::vector<std::string>& changes)>;

/// How far it came, and at what cost.
struct Outcome {
  Setting setting;
  std::string failure;  // "": it ran to the end
  // Cost of the steps alone
  double cpuSeconds = 0;  // median of the rounds
  std::uint64_t steps = 0, forceEvaluations = 0, vertexSteps = 0;
};

struct Trial : Outcome {
  std::vector<Shapes> shapes;      // at the times asked for, as far as it came
  std::vector<LineageEntry> born;  // the whole lineage
  std::vector<DivisionRecord> divisions;
};

/// Runs it `rounds` times, which give the same, through the times [time], rising multiples of its time step. Runs a
/// setting. `failure` tells if it cannot run, does not reach the end, or takes more CPU time than `maxSeconds` [s].
Trial runTrial(const ReadScenario& read, const Setting& setting, const std::vector<double>& times,
               const Execution& execution, int rounds, double maxSeconds = INFINITY);

/// How long a scene can be told apart from chaos.
struct Horizon {
  double end = 0;       // [time] up to which comparisons make sense: the scene's end, or before it parts
  double rounding = 0;  // [length] to what one unit in the last place has grown by then
  bool parted = false;  // whether one unit in the last place has grown too much by then
  double minTimeStep = 0, maxTimeStep = 0;  // [time] that the scene's own settings took
};

/// Runs the scene together with a twin with x of one vertex moved by one unit in the last place, until that has
/// grown by `amplification`, as errors of the time steps would too, or until `latest`. Throws NumericalError.
Horizon findHorizon(const Scene& scene, const Execution& execution, std::optional<double> latest, double amplification);

}  // namespace morula
