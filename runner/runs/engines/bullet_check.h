#pragma once
// Holds a finished run against the same scene in Bullet, as the scenario's check.bullet asks.
#include <optional>

#include "engines/external_run.h"
#include "simulation/world.h"

namespace morula {

struct BulletFindings {
  std::vector<CheckResult> results;   // of kind "bullet"
  std::optional<ExternalRun> bullet;  // if it came to the same end
};

/// Nothing if the scenario does not ask. Without Bullet in this build one result that says so and passes; a
/// Bullet that breaks or does not answer is a result that fails. `end`: ours. `frameTimes`: ExternalQuestion's.
BulletFindings checkAgainstBullet(const Scenario& scenario, const World& end, bool quiet,
                                  const std::vector<double>& frameTimes = {});

/// Results that tell what was not looked at.
bool wasSkipped(const CheckResult& result);

/// The tolerances of the scenario, or those that fit it where it has none.
BulletCheck tolerancesFor(const Scenario& scenario);

/// One result for each tolerance, of the worst cell. `shapes`: Bullet's, in the order of ours.
std::vector<CheckResult> compareWithBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                                           const BulletCheck& check);

}  // namespace morula
