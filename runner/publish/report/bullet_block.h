#pragma once
// Morula's results beside Bullet's: the numbers that decide, pictures, and the distances of the surfaces.
#include "report/page_parts.h"
#include "report_data/run_words.h"

namespace morula {

struct BulletShown {
  std::string picture;  // id of the element with Bullet's picture, for the explorer; "": none
  bool swipe = false;   // true: both pictures lie over each other; only once in a block
};

/// Makes the block. `stored`: the checks stored with the run; null if none can be stored. `ours`: the run made again.
Document besideBullet(const Scenario& scenario, const World& ours, const BulletAgain& again,
                      const std::vector<CheckResult>* stored, const BulletShown& shown);

/// Adds the findings on Bullet that a reader must know first: Bullet was not run, gave no result, or gave another
/// result than the stored one.
void judgeBullet(const RunFacts& run, std::vector<Finding>& findings);

/// Makes the section on all runs that were made again in Bullet; empty if there are none. In the explorer Bullet's runs
/// follow all others.
PageSection bulletSection(const std::vector<RunFacts>& runs);

/// For a check: runs the first scenarios that were compared with Bullet, those that differ before others, again in both.
void runCheckedInBullet(std::vector<CheckedScenario>& checked, const ReportQuestion& question);
/// A section of each of these.
std::vector<PageSection> bulletSections(const std::vector<CheckedScenario>& checked);

}  // namespace morula
