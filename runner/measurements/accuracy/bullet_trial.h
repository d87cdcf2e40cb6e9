#pragma once
// Trials in Bullet: the same scene, as a trial like those of our own settings.
#include "accuracy/trial.h"
#include "values/baseline.h"

namespace morula {

/// Number of doublings of the longest time step otherwise tried: B2 and B3 may bear such steps.
inline constexpr int bulletDoublings = 3;

bool areMultiples(const std::vector<double>& times, double timeStep);

struct BulletSetting {
  Baseline baseline = Baseline::b1;
  double timeStep = 0;   // [time]
  double margin = 0.01;  // [radii of the egg] of each surface; of account only where cells touch
  int iterations = 1;    // of Bullet's position solver; of account where cells touch, and to B2's links
};

/// "bullet b1, margin 0.01, 2 iterations"
std::string seriesName(const BulletSetting& setting, bool touching);

/// Returns the settings of a baseline besides the time step, which is left 0: four margins if cells touch, and one to
/// four iterations if there is something to iterate.
std::vector<BulletSetting> bulletChoices(Baseline baseline, bool touching);

/// From eight times `longest` down by so many halvings of it, and `longestStable` unless it is 0, as far as
/// all times are multiples of them: each as Bullet takes it, a float.
std::vector<double> bulletTimeSteps(double longest, double longestStable, int halvings,
                                    const std::vector<double>& times);

struct BulletSearch {
  double longest = 0;        // [time] step that ours begin with
  double longestStable = 0;  // [time] of all steps the longest that B1 can bear; 0: not known
  int halvings = 4;          // of `longest`
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

/// Bullet at its best: all its baselines that the scene can be put to (bulletIncompatibilities), with all their
/// choices in time steps down to `longest`, once each. Then those choices of which some run is beaten by no
/// other in both error and time go on to the shortest steps, in as many rounds as ours. Nothing if Bullet is
/// absent. `errorOf`: nothing if the trial has failed.
std::vector<BulletTrial> tryBullet(const Scenario& scenario, const BulletSearch& search,
                                   const std::function<std::optional<double>(const Trial&)>& errorOf,
                                   const std::function<void(const std::string&)>& tell);

/// Which of these runs no other beats in both; those without an error are beaten.
std::vector<bool> unbeaten(const std::vector<std::optional<double>>& errors, const std::vector<double>& seconds);

}  // namespace morula
