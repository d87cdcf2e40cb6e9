#pragma once
// Checks across parameters that have files of their own. Private to this module.
#include "scenario/loading.h"

namespace morula::scenario {

/// Senses that no gene reads, that lack a part of the scene, or that start cells hold already.
void checkSenses(const Scenario& scenario, Reading& reading, const Node& root);

/// A size at division that cells without growth are to reach.
void checkDivisionSize(const Scenario& scenario, Reading& reading, const Node& root);
/// A size that nothing can reach: "file:line:column: path: what; what would be right".
std::vector<std::string> sizeWarnings(const Scenario& scenario, const Node& root);

/// Connections that nothing could make, or with two forces.
void checkConnections(const Scenario& scenario, Reading& reading, const Node& root);

/// That a scene has what its division planes and chirality go by.
void checkPlanes(const Scenario& scenario, Reading& reading, const Node& root);

/// Adhesion: what sticks must give way, and the law must know how.
void checkAdhesion(const Scenario& scenario, Reading& reading, const Node& root);

/// Cells that crawl where nothing bears them.
void checkMotility(const PhysicsParameters& physics, Reading& reading, const Node& root);

/// Quasi-static growth, with parts that act for a time or have no energy to come to rest at.
void checkSettling(const Scenario& scenario, Reading& reading, const Node& root);

}  // namespace morula::scenario
