#pragma once
// Compares a finished run with the same scene in Bullet, as the scenario's check.bullet asks.
#include <optional>

#include "engines/external_run.h"
#include "simulation/simulation.h"

namespace morula {

struct BulletFindings {
  std::vector<CheckResult> results;   // results of kind "bullet"
  std::optional<ExternalRun> bullet;  // if Bullet reached the same end
};

/// Returns nothing if the scenario does not ask; one result that passes and says so in a build without Bullet; one that
/// fails if Bullet breaks or does not answer. `end`: our end. `frameTimes`: as in ExternalQuestion.
BulletFindings checkAgainstBullet(const Scenario& scenario, const World& end, bool quiet,
                                  const std::vector<double>& frameTimes = {});

/// Returns true for a result of a comparison that was skipped.
bool wasSkipped(const CheckResult& result);

/// Returns the tolerances of the scenario, or defaults that fit it if it has none.
BulletCheck tolerancesFor(const Scenario& scenario);

/// Returns one result for each tolerance, for the worst cell. `shapes`: vertices in Bullet, in the order of our cells.
std::vector<CheckResult> compareWithBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                                           const BulletCheck& check);

}  // namespace morula
