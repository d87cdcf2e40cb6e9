#pragma once
// Checks across parameters that have files of their own. Private to this module.
#include "scenario/loading.h"

namespace morula::scenario {

/// A scenario to check, and the problems that checks add.
struct SceneCheck {
  const Scenario& scenario;
  Reading& reading;
  const Node& root;

  const Scene& scene() const { return scenario.scene; }
  /// The mechanics of a scenario that has some.
  const MechanicsScene& mechanics() const { return *scenario.scene.mechanics; }
  const PhysicsParameters& physics() const { return mechanics().physics; }

  /// Adds a problem at the place of a parameter.
  void refuse(const std::string& path, const std::string& wrong, const std::string& right) const {
    reading.problems.add(placeOf(root, path), path, wrong, right);
  }
};

/// Checks for senses that no gene reads, that lack a part of the scene, or that start cells already hold.
void checkSenses(const SceneCheck& check);

/// Checks that no lengths are given for a first cycle that cells have not.
void checkFirstCycle(const SceneCheck& check);

/// Checks that cells with a size at division can grow.
void checkDivisionSize(const SceneCheck& check);
/// Returns warnings of sizes that no cell can reach: "file:line:column: path: what; what would be right".
std::vector<std::string> sizeWarnings(const Scenario& scenario, const Node& root);
/// Returns warnings of intervals in `record` that are shorter than the steps of a scene that settles.
std::vector<std::string> intervalWarnings(const Scenario& scenario, const Node& root);

/// Returns a warning if the genes alone let a line of descent outgrow the paths of cells before the run's end.
std::vector<std::string> descentWarnings(const Scenario& scenario, const Node& root);

/// Checks for connections that nothing could make, or that have two forces.
void checkConnections(const SceneCheck& check);

/// Checks how cells divide: for rules that no cell follows, and for impossible shares and tilts.
void checkDivision(const SceneCheck& check);

/// Checks that a scene has the parts that its division planes and chirality need.
void checkPlanes(const SceneCheck& check);

/// Checks that adhesive cells can give way, and that the contact law supports adhesion.
void checkAdhesion(const SceneCheck& check);

/// Checks that cells that crawl have something to crawl on.
void checkMotility(const SceneCheck& check);

/// Checks quasi-static growth for parts that act in time, or have no energy that could be minimal.
void checkSettling(const SceneCheck& check);

}  // namespace morula::scenario
