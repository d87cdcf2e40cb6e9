#pragma once
// Ours beside Bullet's: the numbers that decide, pictures, and how far the surfaces are apart.
#include "report/parts.h"
#include "report_data/words.h"

namespace morula {

struct BulletShown {
  std::string picture;  // id of the element with Bullet's picture, where the explorer looks for it; "": none
  bool swipe = false;   // ours and Bullet's over each other; once in a block
};

/// `stored`: the checks that are stored with the run, and null where none can be. `ours`: the run made again.
Document besideBullet(const Scenario& scenario, const World& ours, const BulletAgain& again,
                      const std::vector<CheckResult>* stored, const BulletShown& shown);

/// Adds the findings on Bullet that a reader must know first: that it was not asked, gave no answer, or another one
/// than is stored.
void judgeBullet(const RunFacts& run, std::vector<Finding>& findings);

/// Makes the section on all runs that were made again in Bullet; empty without any. Bullet's runs stand in the explorer
/// behind all others.
PageSection bulletSection(const std::vector<RunFacts>& runs);

/// For a check: runs the first scenarios that were compared with Bullet, those that differ before others, again in both.
void runCheckedInBullet(std::vector<CheckedScenario>& checked, const ReportQuestion& question);
/// A section of each of these.
std::vector<PageSection> bulletSections(const std::vector<CheckedScenario>& checked);

}  // namespace morula
