#pragma once
// One run of a scene in one way: what it came to, and what it cost.
#include <cmath>
#include <cstdint>

#include "accuracy/setting.h"
#include "accuracy/state_error.h"
#include "simulation/world.h"

namespace morula {

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

/// Runs it `rounds` times, which give the same, through the times [time], rising multiples of its time step.
/// What cannot run, not to the end, or takes more CPU time than `mostSeconds` [s] is told in `failure`.
Trial runTrial(const ReadScenario& read, const Setting& setting, const std::vector<double>& times,
               const Execution& execution, int rounds, double mostSeconds = INFINITY);

/// How long a scene can be told apart from chaos.
struct Horizon {
  double end = 0;       // [time] up to which comparisons make sense: the scene's end, or before it parts
  double rounding = 0;  // [length] to what one unit in the last place has grown by then
  bool parted = false;  // whether one unit in the last place has grown too much by then
  double leastTimeStep = 0, mostTimeStep = 0;  // [time] that the scene's own settings took
};

/// Runs the scene together with a twin with x of one vertex moved by one unit in the last place, until that has
/// grown by `amplification`, as errors of the time steps would too, or until `latest`. Throws NumericalError.
Horizon findHorizon(const Scene& scene, const Execution& execution, std::optional<double> latest, double amplification);

}  // namespace morula
