#pragma once
// Two worlds of one scene that differ in one last place: the measure of chaos in a scene.
#include <functional>
#include <vector>

#include "base/hash.h"
#include "golden/golden.h"
#include "loop/run.h"

namespace morula {

class Twins {
 public:
  /// Both are worlds of one scene with bodies at step 0; x of the twin's first vertex is moved by one unit in the last
  /// place.
  Twins(World world, World twin);

  /// Both go on by one step. Returns the largest difference of any coordinate [length]; infinite from where other cells
  /// live, and once the twin cannot go on. Throws NumericalError if the undisturbed one cannot, or if the twin lacks
  /// memory or the like (Want); both have tried then.
  double step();

  const World& world() const { return run_.world(); }  // the one that nothing was done to
  double ulp() const { return ulp_; }            // [length] by which the twin was moved

 private:
  double ulp_;
  Run run_, twin_;
  bool twinGoesOn_ = true;
};

struct TwinRun {
  std::vector<GoldenGrowth> growth;  // decades from 1e-15 up, as far as they are reached
  Hash end;                          // of the undisturbed world's last state
};

/// Runs twins to the end. Their distance is in radii of the egg, and infinite once the twin cannot go on. `watch` is
/// called before every step.
TwinRun runTwins(World world, World twin, const std::function<void(const World&)>& watch = {});

}  // namespace morula
