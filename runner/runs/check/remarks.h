#pragma once
// Remarks on a run that is fine: whether a quasi-static one came as near to equilibrium as its scenario
// asks, and divisions across the longest extent of cells that have none: another mesh or time step may cut them
// elsewhere.
#include <functional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "division/division_record.h"
#include "physics/parameters.h"
#include "simulation/simulation.h"
#include "state/scene.h"
#include "values/scenario_data.h"

namespace morula {

/// A sentence on settlings that ended above what the scene asks for: how many, the farthest, and what to change; "" where
/// there are none.
std::string unsettledText(const PhysicsParameters& asked, const std::vector<SettlingRecord>& settlings);

/// A sentence on how cells have settled by a number of evaluations, and on what is left at the end; "" for others.
std::string settledText(const PhysicsParameters& physics, const std::vector<SettlingRecord>& settlings);

/// A sentence on how far from rest the settlings end that were measured (physics.settle.sample); "" where none was.
std::string distanceText(const std::vector<SettlingRecord>& settlings);

/// One line for each entry of `experiments`: what was done to which cells and when, or that it was never due.
std::vector<std::string> experimentLines(const Scenario& scenario, const std::vector<ExperimentRecord>& done);

/// Returns true if places in a reference lie so much farther apart, or nearer, than cells that their unit is another.
bool isOtherScale(double scale);
/// Returns true if the mirror image of so many cells fits a reference clearly better than the cells do. `shape` and
/// `mirrored`: distances of the shapes (Superposition::shape).
bool fitsMirrored(std::size_t cells, double shape, double mirrored);

/// Sentences on check.reference.positions at the end of a run: that they are in another unit than the scene, or in a
/// frame that mirrors; "" where neither shows.
std::string positionsText(const World& world, const Scenario& scenario);

/// Returns the divisions across the longest extent of a cell whose next extent is nearly as long. `describe` gives the
/// substances of a state in `lineage`.
std::vector<DivisionRecord> ambiguousDivisions(const Scene& scene, const std::vector<LineageEntry>& lineage,
                                               const std::function<std::string(StateId)>& describe,
                                               const std::vector<DivisionRecord>& divisions);

}  // namespace morula
