#pragma once
// The converged reference: the scene on its own mesh in time steps that no longer matter, and on other meshes.
#include <map>

#include "accuracy/accuracy.h"

namespace morula {

/// A setting that computes in doubles, whose error falls with its time step alone.
Setting convergent(Setting setting, Integrator integrator);

/// Runs a scene in many ways, at the times of comparison.
struct AccuracyRuns {
  const ReadScenario& read;
  const AccuracyOptions& options;
  Setting usual;              // the scenario's, with the longest time step
  std::vector<double> times;  // [time] of comparison
  double eggRadius = 1;       // [length]

  Trial trial(const Setting& setting, int rounds, double maxSeconds = INFINITY) const;
};

/// The scene on its own mesh, `halvings` of the usual time step down, by the better of two integrators; the
/// other one confirms it (AccuracyReference::witness). `about` is filled. Throws InputError if neither runs to the end.
Trial findTimeReference(const AccuracyRuns& runs, int halvings, const Horizon& horizon, const std::string& file,
                        AccuracyReference& about);

/// The scene on other meshes than its own, each solved with time steps that add little to the mesh's error.
struct MeshStudy {
  MeshError error;
  std::map<std::uint64_t, Trial> solved;  // by level, but for the scene's own
};

/// `own` is the time reference. Finer meshes take part as far as `options.budget` allows; coarser ones show
/// the order where it does not. `furtherLevels` are solved too.
MeshStudy studyMeshes(const AccuracyRuns& runs, const Scenario& scenario, const Trial& own,
                      const std::vector<std::uint64_t>& furtherLevels);

}  // namespace morula
