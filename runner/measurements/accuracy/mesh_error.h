#pragma once
// How far two runs are apart, and what a mesh costs: the same scene on meshes of several fineness, all with
// converged time steps.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/trial.h"

namespace morula {

/// Between two runs. Flat faces count in the surfaces.
struct RunDistance {
  StateError worst, atEnd;         // of all times after the start; at the last one compared
  double atStart = 0;              // [radii of the egg] surfaces at time 0: faces are flat, cells are not
  double until = 0;                // [time] of the last comparison; 0: there was none
  bool touch = false;              // whether cells of the reference do
  std::optional<double> partedAt;  // [time] first comparison at which other cells lived
  /// Absent: there was no comparison.
  std::optional<double> error() const;
};

/// Up to where other cells live, and before that time. The meshes may differ.
RunDistance compareRuns(const Trial& trial, const Trial& reference, double eggRadius, double before = INFINITY);

/// [degrees] Axes of one division that are farther apart are two events, and what follows is compared no more.
inline constexpr double anotherPlane = 10;

/// The scene on one mesh, with converged time steps.
struct SolvedMesh {
  std::uint64_t level = 0;  // of the icosphere
  const Trial* trial = nullptr;
};

/// The error of one mesh: distance to the finest, and by Richardson what is left of the finest's own.
struct LevelError {
  std::uint64_t level = 0;
  StateError worst, atEnd;
};

struct MeshError {
  std::string unknown;                  // why it is not known; "": it is
  std::string limit;                    // why no finer mesh took part; "": as many as help did
  bool none = false;                    // cells have no mesh: spheres
  std::vector<LevelError> levels;       // that took part, rising
  std::uint64_t own = 0;                // level
  double order = 0;                     // in the length of an edge; 0: it does not converge
  bool orderIsObserved = false;         // from three levels; else assumed
  double atStart = 0;                   // [radii of the egg] of it: surfaces at time 0 against the finest's
  double until = 0;                     // [time] compared so far
  std::optional<double> partedAt;       // [time] other cells live on another mesh from then on
  std::optional<DividedElsewhere> cut;  // on another mesh a cell divides across another plane: compared up to before
  bool touch = false;                   // whether cells do, on the finest
  double timeError = 0;                 // left in the finer runs
  double cpuSeconds = 0;                // of all of them

  const LevelError* find(std::uint64_t level) const;
  /// Returns the error of the scenario's own mesh; absent: not known.
  std::optional<double> error() const;
  /// Returns the error of any icosphere, from those that took part; absent: not known.
  std::optional<double> errorOf(std::uint64_t level) const;
};

/// Below it errors hardly fall from mesh to mesh, and nothing is extrapolated.
inline constexpr double minMeshOrder = 1;

/// From two or three neighbouring levels, rising. Sets levels, order, atStart, until and partedAt.
MeshError estimateMeshError(const std::vector<SolvedMesh>& solved, std::uint64_t own, double eggRadius);

}  // namespace morula
