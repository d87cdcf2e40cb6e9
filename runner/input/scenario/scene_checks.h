#pragma once
// Checks across parameters that have files of their own. Private to this module.
#include "scenario/loading.h"

namespace morula::scenario {

/// The scenario that a check looks at, and the problems that it adds.
struct SceneCheck {
  const Scenario& scenario;
  Reading& reading;
  const Node& root;

  const Scene& scene() const { return scenario.scene; }
  /// The mechanics of a scenario that has some.
  const MechanicsScene& mechanics() const { return *scenario.scene.mechanics; }
  const PhysicsParameters& physics() const { return mechanics().physics; }

  /// Says it of a parameter, at its place.
  void refuse(const std::string& path, const std::string& wrong, const std::string& right) const {
    reading.problems.add(placeOf(root, path), path, wrong, right);
  }
};

/// Senses that no gene reads, that lack a part of the scene, or that start cells hold already.
void checkSenses(const SceneCheck& check);

/// A size at division that cells without growth are to reach.
void checkDivisionSize(const SceneCheck& check);
/// A size that nothing can reach: "file:line:column: path: what; what would be right".
std::vector<std::string> sizeWarnings(const Scenario& scenario, const Node& root);
/// Warnings of intervals in `record` that are shorter than the steps of a scene that settles.
std::vector<std::string> intervalWarnings(const Scenario& scenario, const Node& root);

/// Connections that nothing could make, or with two forces.
void checkConnections(const SceneCheck& check);

/// How cells divide: rules that no cell follows, shares and tilts that cannot be.
void checkDivision(const SceneCheck& check);

/// Checks that a scene has the parts that its division planes and chirality need.
void checkPlanes(const SceneCheck& check);

/// Adhesion: what sticks must give way, and the law must know how.
void checkAdhesion(const SceneCheck& check);

/// Cells that crawl where nothing bears them.
void checkMotility(const SceneCheck& check);

/// Quasi-static growth, with parts that act for a time or have no energy to come to rest at.
void checkSettling(const SceneCheck& check);

}  // namespace morula::scenario
