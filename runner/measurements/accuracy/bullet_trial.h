#pragma once
// Trials of a scene in Bullet, in the form of trials of Morula's settings.
#include "accuracy/trial.h"
#include "values/baseline.h"

namespace morula {

/// Number of doublings of the usual longest time step, as B2 and B3 may bear longer steps.
inline constexpr int bulletDoublings = 3;

bool areMultiples(const std::vector<double>& times, double timeStep);

struct BulletSetting {
  Baseline baseline = Baseline::b1;
  double timeStep = 0;   // [time]
  double margin = 0.01;  // [radii of the egg] margin of each surface; it matters only if cells touch
  int iterations = 1;    // iterations of Bullet's position solver; they matter if cells touch, and for B2's links
};

/// Returns "bullet b1, margin 0.01, 2 iterations".
std::string seriesName(const BulletSetting& setting, bool touching);

/// Returns the settings of a baseline, with the time step left 0: four margins if cells touch, and one to four
/// iterations if there is something to iterate.
std::vector<BulletSetting> bulletChoices(Baseline baseline, bool touching);

/// Returns time steps from eight times `longest` down to `longest` halved `halvings` times, and `longestStable` unless
/// it is 0. All times must be multiples of them. Each is rounded to a float, as Bullet takes it.
std::vector<double> bulletTimeSteps(double longest, double longestStable, int halvings,
                                    const std::vector<double>& times);

struct BulletSearch {
  double longest = 0;        // [time] longest step of Morula's settings
  double longestStable = 0;  // [time] longest step that B1 can bear; 0: not known
  int halvings = 4;          // number of halvings of `longest`
  const std::vector<double>& times;
  Execution execution;
  int rounds = 3;
  std::string program;
};

struct BulletTrial {
  BulletSetting setting;
  std::string series;
  Trial trial;
};

/// Runs a scene in Bullet at its best. First all possible baselines (bulletIncompatibilities) with all choices run once
/// with time steps down to `longest`. Then choices with a run that no other beats in both error and time run with
/// shorter steps, in as many rounds as Morula's. Returns nothing if Bullet is absent. `errorOf`: returns nothing for a
/// failed trial.
std::vector<BulletTrial> tryBullet(const Scenario& scenario, const BulletSearch& search,
                                   const std::function<std::optional<double>(const Trial&)>& errorOf,
                                   const std::function<void(const std::string&)>& tell);

/// Returns true for each run that no other beats in both error and time; runs without an error are beaten.
std::vector<bool> unbeaten(const std::vector<std::optional<double>>& errors, const std::vector<double>& seconds);

}  // namespace morula
