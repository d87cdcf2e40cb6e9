#pragma once
// The conditions of a scenario's `check` that must hold of its run: observed during the run, reported afterwards.
#include <string>
#include <vector>

#include "golden/check_result.h"
#include "observation/observation.h"
#include "scenario/scenario.h"

namespace morula {

/// Sees the world at the start and after every step, and measures only what the checks ask for.
class Invariants {
 public:
  explicit Invariants(const CheckParameters& check) : check_(check) {}

  void observe(const World& world);
  /// One result of kind "invariant" for each check that is given; `end` is the world at the end of a run that
  /// ended well.
  std::vector<CheckResult> results(const World& end) const;
  /// Returns the results of a run that did not come to its end: only conditions on every step.
  std::vector<CheckResult> watched() const;
  /// True while nothing that must hold at every step has been broken.
  bool holdSoFar() const;
  /// [1] The least and the most that was seen, if the volume is checked.
  Bounds volumes() const { return {minVolume_.value, maxVolume_.value}; }
  /// True if anything at all is to be checked.
  static bool areGiven(const CheckParameters& check);

 private:
  /// The worst value so far, and whose and when it was.
  struct Extreme {
    double value = 0;
    bool seen = false;
    std::uint64_t step = 0;
    std::optional<CellPath> cell = {};
  };
  std::vector<CheckResult> collect(const World* end) const;
  void observeVolumes(const Observation& now);
  static void raise(Extreme& most, double value, const World& world, std::optional<CellPath> cell = {});
  static void lower(Extreme& least, double value, const World& world, std::optional<CellPath> cell = {});

  CheckParameters check_;
  Extreme minVolume_, maxVolume_, extent_, energy_, stray_;
  std::optional<Vector> momentum_;  // at the start
};

/// The check of a run that had to stop: with all of `fails` in the reason. `failure`: why it stopped; "" if it did not.
CheckResult stopsAsItMust(const std::vector<std::string>& fails, const std::string& failure);

}  // namespace morula
