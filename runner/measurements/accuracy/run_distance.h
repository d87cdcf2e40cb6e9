#pragma once
// The distance of two runs of one scene.
#include <cmath>
#include <optional>
#include <span>

#include "accuracy/comparison_times.h"
#include "accuracy/trial.h"

namespace morula {

/// The distance of two runs. Flat faces count in the surfaces.
struct RunDistance {
  StateError worst, atEnd;           // the largest over all times after the start; that at the last comparison
  std::optional<StateError> atRest;  // the median over the quiet times; absent if no time is quiet
  double atStart = 0;                // [radii of the egg] distance of surfaces at time 0, from flat faces
  double until = 0;                  // [time] the last comparison; 0: none
  bool touch = false;                // true: cells of either run touch
  std::optional<double> partedAt;    // [time] first comparison at which other cells lived
  /// Returns the largest error; absent without a comparison.
  std::optional<double> error() const;
};

/// The limits of a comparison of runs.
struct ComparisonLimits {
  double before = INFINITY;              // [time] only earlier times are compared
  std::span<const SceneEvent> events{};  // events near which no time is quiet
  std::span<const double> at{};          // [time] the only times to compare, rising; empty: all that both runs have
};

/// Compares runs at the times that both have, until other cells live. The meshes may differ.
RunDistance compareRuns(const Trial& trial, const Trial& reference, double eggRadius,
                        const ComparisonLimits& limits = {});

}  // namespace morula
