#pragma once
// Holds a finished run against its golden file and against what must always hold.
#include <string>

#include "check/invariants.h"
#include "check/sanity_check.h"
#include "golden/check_result.h"
#include "golden/golden.h"
#include "loop/simulate.h"
#include "store/store.h"

namespace morula {

/// A run that is held against what must hold whatever its golden says.
struct CheckedRun {
  Simulation run;
  Invariants invariants;            // which have watched it
  std::vector<CheckResult> sanity;  // of a run that came to its end
};

/// Observes what must hold at every step. `asked`: the conditions of the scenario's `check` are tested, too; without
/// conditions on every step nothing is due.
class RunChecks : public Observer {
 public:
  /// `start`: the world at time 0, also of a run that goes on from a checkpoint.
  RunChecks(const Scenario& scenario, const World& start, bool asked);
  void see(const World& world) override;
  std::uint64_t stepsUntilDue(const World&) const override { return watches_ ? 1 : neverDue; }
  CheckedRun of(Simulation run) const;

 private:
  const Scenario& scenario_;
  bool asked_, watches_;
  Invariants invariants_;
  SanityCheck sanity_;
};

/// Runs the scenario with its checks.
CheckedRun simulateChecked(const Scenario& scenario, const Execution& how, RunOptions options = {}, bool asked = true);

/// Returns the data of the run's golden; without `withPicture` they say that no picture was drawn.
GoldenData observe(const Scenario& scenario, const Simulation& run, bool withPicture = true);

/// A stored run as its golden would tell it: what decided it, its lineage, and its cells where it was sampled last if
/// that was its end.
GoldenData goldenOf(const StoredRun& run, const RunResults& results, const Scenario& scenario);

/// The golden in the file. One without lines `parameter`, whose scenario has changed since, gets them from the
/// scenario as it was last committed, if that has the golden's hash. Throws InputError.
Golden readAccepted(const Scenario& scenario, const std::filesystem::path& file);

/// The golden's file for the scenario; the path may not exist.
std::filesystem::path goldenFile(const Scenario& scenario);

/// The run's golden, compared with what was observed of the run, and invariants. With `needsGolden` a missing golden
/// file is a failed check; otherwise only invariants are checked then.
CheckReport check(const Scenario& scenario, const CheckedRun& checked, const GoldenData& observed, bool needsGolden);

/// All checks that the run alone decides: of a run that failed, whether it had to.
std::vector<CheckResult> checkWithoutGolden(const Scenario& scenario, const CheckedRun& checked);

/// Returns the results of conditions that must hold whatever the golden says.
std::vector<CheckResult> checkInvariants(const Scenario& scenario, const CheckedRun& checked);

/// Checks a scenario that must stop: that it did, and said why. `failure`: the reason; "" if it ended well.
CheckReport checkStop(const Scenario& scenario, const std::string& failure);

}  // namespace morula
