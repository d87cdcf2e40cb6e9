#pragma once
// The sanity checks of a run's end. Every run with bodies has them, without being asked.
#include <optional>
#include <string>
#include <vector>

#include "golden/check_result.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

namespace morula {

/// Remembers of the start what the end is held against.
class SanityCheck {
 public:
  /// `start`: the world at time 0, also of a run that goes on from a checkpoint.
  explicit SanityCheck(const World& start);

  /// One result of kind "sanity" per quantity; none without bodies. A scene that says `check: {sane: false}`
  /// passes all; with `held` it must then really lie outside of a bound, or else a result of its own fails:
  /// what it says is not true any more.
  std::vector<CheckResult> results(const World& end, const CheckParameters& check, bool held) const;

 private:
  // [force·length] at the start, where nothing that is not in it can add to it
  std::optional<double> energy_;
  double energyScale_ = 0;  // [force·length] what its parts sum up to without their signs
  std::vector<CellPath> cells_;
  std::vector<std::string> states_;  // what they hold: cells may stick by it
};

}  // namespace morula
