#pragma once
// Ours and Bullet's side by side, and how far the surfaces are apart.
#include <string>
#include <vector>

#include "image/image.h"
#include "scenario/scenario.h"
#include "simulation/world.h"

namespace morula {

/// Three pictures in a row: ours, Bullet's, and ours again in the colours of the distance of each vertex from
/// Bullet's surface, with a scale. `shapes`: Bullet's cells, in the order of ours.
Image drawBesideBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                       const Scenario& scenario);

}  // namespace morula
