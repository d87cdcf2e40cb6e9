#pragma once
// Ours and Bullet's side by side, and how far the surfaces are apart.
#include <vector>

#include "comparison/comparison.h"
#include "scenario/scenario.h"
#include "simulation/world.h"

namespace morula {

/// Ours, Bullet's, and the distance of each of our vertices from Bullet's surface (drawComparison). `shapes`:
/// the vertices of Bullet's cells, in the order of ours.
Drawing drawBesideBullet(const World& ours, const std::vector<std::vector<Point>>& shapes,
                         const Scenario& scenario);

}  // namespace morula
