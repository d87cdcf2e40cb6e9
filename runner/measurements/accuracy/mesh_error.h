#pragma once
// The error of a mesh: the same scene on meshes of several fineness, all with converged time steps.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "accuracy/run_distance.h"

namespace morula {

/// [degrees] If axes of one division differ by more, they are two events, and the comparison ends.
inline constexpr double anotherPlane = 10;

/// The scene on one mesh, with converged time steps.
struct SolvedMesh {
  std::uint64_t level = 0;  // level of the icosphere
  const Trial* trial = nullptr;
};

/// The error of one mesh: its distance to the finest, plus Richardson's estimate of the finest's own error.
struct LevelError {
  std::uint64_t level = 0;
  StateError worst, atEnd;
  std::optional<StateError> atRest = {};  // absent if no time is quiet
};

struct MeshError {
  std::string unknown;                  // reason for an unknown error; "" if it is known
  std::string limit;                    // reason why no finer mesh took part; "" if none would help
  bool none = false;                    // true: cells are spheres without a mesh
  std::vector<LevelError> levels;       // levels that took part, rising
  std::uint64_t own = 0;                // level of the scenario's own mesh
  double order = 0;                     // order in the length of an edge; 0: no convergence
  bool orderIsObserved = false;         // true: observed on three levels; false: assumed
  double atStart = 0;                   // [radii of the egg] distance of `own` from the finest at time 0
  double until = 0;                     // [time] the last comparison
  std::optional<double> partedAt;       // [time] from then on other cells live on another mesh
  std::optional<DividedElsewhere> cut;  // the first division with another plane on another mesh ends the comparison
  bool touch = false;                   // true: cells touch on the finest mesh
  double timeError = 0;                 // error of the time step in the finer runs
  double cpuSeconds = 0;                // CPU time of all runs

  const LevelError* find(std::uint64_t level) const;
  /// Returns the error of the scenario's own mesh; absent if unknown.
  std::optional<double> error() const;
  /// Returns the error of any icosphere, from the levels that took part; absent if unknown.
  std::optional<double> errorOf(std::uint64_t level) const;
};

/// Min order for an extrapolation: below it errors hardly fall from mesh to mesh.
inline constexpr double minMeshOrder = 1;

/// Estimates the error of a mesh from two or three neighbouring levels, rising. Costs and `limit` are left empty. No time
/// near one of the `events` is quiet.
MeshError estimateMeshError(const std::vector<SolvedMesh>& solved, std::uint64_t own, double eggRadius,
                            std::span<const SceneEvent> events = {});

}  // namespace morula
