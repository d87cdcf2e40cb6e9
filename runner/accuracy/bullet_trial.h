#pragma once
// The same scene in Bullet, as a trial like those of our own settings.
#include "accuracy/trial.h"
#include "baseline/baseline.h"

namespace morula {

/// Of the longest time step otherwise tried: B2 and B3 may bear such.
inline constexpr int bulletDoublings = 3;

bool areMultiples(const std::vector<double>& times, double timeStep);

struct BulletSetting {
  Baseline baseline = Baseline::b1;
  double timeStep = 0;   // [time]
  double margin = 0.01;  // [radii of the egg] of each surface; of account only where cells touch
};

/// "bullet b1, margin 0.01"
std::string seriesName(const BulletSetting& setting, bool touching);

/// Those that the scene can be put to: none if Bullet is absent or has no such thing (unfitForBullet). Steps
/// from eight times `longest` down by halves, as far as all times are multiples of them.
std::vector<BulletSetting> bulletSettings(const Scenario& scenario, double longest, int halvings,
                                          const std::vector<double>& times);

/// [runTrial] in a process of its own. Cost: CPU time of Bullet's steps alone.
Trial runBulletTrial(const Scenario& scenario, const BulletSetting& setting, const std::vector<double>& times,
                     const Execution& execution, int rounds, const std::string& program);

}  // namespace morula
