#pragma once
// Holds a finished run against its golden file and against what must always hold.
#include <string>

#include "check/invariants.h"
#include "golden/check_result.h"
#include "golden/golden.h"
#include "loop/simulate.h"

namespace morula {

/// What the run's golden would say.
GoldenData observe(const Scenario& scenario, const Simulation& run, bool withPicture = true);

/// The golden in the file. One without lines `parameter`, whose scenario has changed since, gets them from the
/// scenario as it was last committed, if that has the golden's hash. Throws InputError.
Golden readAccepted(const Scenario& scenario, const std::filesystem::path& file);

/// The golden's file for the scenario; the path may not exist.
std::filesystem::path goldenFile(const Scenario& scenario);

/// All checks of a run that `invariants` has watched. With `needsGolden` a missing golden file is a failed
/// check; otherwise only invariants are checked then.
CheckReport check(const Scenario& scenario, const Simulation& run, const Invariants& invariants,
                  bool needsGolden);

/// All checks that the run alone decides: of a run that failed, whether it had to.
std::vector<CheckResult> checkWithoutGolden(const Scenario& scenario, const Simulation& run,
                                            const Invariants& invariants);

/// What must hold whatever the golden file says.
std::vector<CheckResult> checkInvariants(const Scenario& scenario, const Simulation& run,
                                         const Invariants& invariants);

/// Of a scenario that must stop: whether it has, and has said why. `failure`: the reason; "" if it ended
/// well.
CheckReport checkStop(const Scenario& scenario, const std::string& failure);

}  // namespace morula
