#pragma once
// A scenario's run in Bullet, made again for its shapes, which no database keeps.
#include <memory>
#include <string>
#include <vector>

#include "engines/bullet_check.h"
#include "report_data/frames.h"

namespace morula {

struct BulletAgain {
  BulletFindings found;  // as checkAgainstBullet finds it now
  Frames frames;         // none unless Bullet came to the same end
};

/// Of a scenario with check.bullet. `ours`: at its end. At most `most` frames, evenly over time; fewer of many vertices, so that
/// the answer stays below mostFrameVertices. `most` is 1 at least.
std::unique_ptr<BulletAgain> runInBulletAgain(const Scenario& scenario, const World& ours, std::size_t most,
                                              bool quiet);

/// The same shapes as frames of a page. What a contact measures is not measured: none of Bullet's is told. Velocities are those
/// of the start.
Frames framesOf(const Scenario& scenario, const std::vector<ExternalFrame>& frames);

/// How the numbers found now lie to those that are stored with the run.
enum class BulletStored { none, same, other };
BulletStored compareWithStored(const std::vector<CheckResult>& found, const std::vector<CheckResult>& stored);

/// "Bullet 3.24": the library that this program was built with.
std::string bulletName();

}  // namespace morula
