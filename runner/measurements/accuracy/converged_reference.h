#pragma once
// The converged reference: the scene on its own mesh in time steps that no longer matter, and on other meshes.
#include <map>

#include "accuracy/accuracy.h"

namespace morula {

/// Returns the setting in doubles with this integrator, whose error falls with its time step alone.
Setting convergent(Setting setting, Integrator integrator);

/// Runs a scene in many ways, at the times of comparison.
struct AccuracyRuns {
  const ReadScenario& read;
  const AccuracyOptions& options;
  Setting usual;                 // the scenario's setting, with the longest time step
  std::vector<double> times;     // [time] all times of comparison
  std::vector<double> rowTimes;  // [time] those of `times` at which rows are compared
  std::vector<SceneEvent> events;
  double eggRadius = 1;  // [length]

  /// Runs a setting through all times.
  Trial trial(const Setting& setting, int rounds, double maxSeconds = INFINITY) const;
  /// Runs the setting of a row, through the times of rows.
  Trial rowTrial(const Setting& setting, int rounds) const;
};

/// Solves the scene on its own mesh, with the usual time step halved `halvings` times, by the better of two
/// integrators; the other one is the witness. Fills `about`. Throws InputError if neither runs to the end.
Trial findTimeReference(const AccuracyRuns& runs, int halvings, const Horizon& horizon, const std::string& file,
                        AccuracyReference& about);

/// Solutions on other meshes than the scene's own, with time steps that add little to the mesh's error.
struct MeshStudy {
  MeshError error;
  std::map<std::uint64_t, Trial> solved;  // by level, without the scene's own
};

/// Solves the scene on other meshes. `own`: the time reference. Finer meshes take part as far as `options.budget`
/// allows; coarser ones show the order otherwise. `furtherLevels` are solved, too.
MeshStudy studyMeshes(const AccuracyRuns& runs, const Scenario& scenario, const Trial& own,
                      const std::vector<std::uint64_t>& furtherLevels);

}  // namespace morula
