#pragma once
// The parameters of division planes, as a scenario gives them [Nilsson 2008, §4.4.2].
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/members.h"
#include "base/vec3.h"
#include "biology/cell_selection.h"

namespace morula {

class DivisionPolicy;

enum class DivisionPlane {  // the number is part of what a scenario means: new planes stand last
  longest,                  // the default
  axis,
  random,  // the thesis' reference
  alternating,
  smallestArea,
  towards,
  awayFrom,
  across,
  polarity,
  shellAxis,
  perpendicular,
  parallel,
  tension,
};

/// How one cell is cut: a plane, and the plane's parameters.
struct PlaneChoice {
  DivisionPlane plane = DivisionPlane::longest;
  Vector axis{1, 0, 0};     // for planes that take one; any length but 0
  std::string substance{};  // for planes that take one: a name, or its beginning and '*'
  bool turnsAway = false;   // polarity with a substance: away from contacts, not to them
  friend bool operator==(const PlaneChoice&, const PlaneChoice&) = default;
};
MORULA_MEMBERS(PlaneChoice, plane, axis, substance, turnsAway)

/// The daughters of a division turn against each other about its axis [simulation/swirls.h].
struct Chirality {
  double angle = 20;  // [degree] whole turn of A; B turns by as much the other way; below 0: the mirror image
  double time = 0.5;  // [time] in which the turning falls to 1/e
  friend bool operator==(const Chirality&, const Chirality&) = default;
};
MORULA_MEMBERS(Chirality, angle, time)

/// How some cells divide. Absent members are as for a cell that no rule names.
struct DivisionRule {
  std::vector<std::string> of{};       // patterns: the rule is for cells that hold a substance for each
  std::vector<CellSelection> cells{};  // and that each of these selects
  std::optional<PlaneChoice> plane{};  // absent: DivisionParameters::otherwise
  std::optional<double> share{};       // [1] daughter A's share of the volume; absent: the plane goes
                                       // through the centre
  std::optional<double> tilt{};        // [degree] standard deviation of the axis from its direction, by the seed
  std::optional<Chirality> chirality{};
};
MORULA_MEMBERS(DivisionRule, of, cells, plane, share, tilt, chirality)

struct DivisionParameters {
  PlaneChoice otherwise{};               // for cells that no rule names
  std::vector<DivisionRule> rules{};     // the first that fits a cell counts
  std::optional<Chirality> chirality{};  // for cells whose rule has none; absent: they do not turn
};
MORULA_MEMBERS(DivisionParameters, otherwise, rules, chirality)

enum class Takes { nothing, axis, substance, polarity };

/// A way to choose where cells divide. To add one: its value above, a file in planes/ with its class and this row,
/// its name below and in policy.cpp.
struct DivisionPlaneKind {
  DivisionPlane plane;
  const char* name;              // as scenarios spell it; {name: [x, y, z]} or {name: a0} if it takes something
  const char* meaning;           // "Cells divide across …"
  Takes takes = Takes::nothing;  // PlaneChoice::axis, ::substance, or an axis that may turn to a substance
  bool needsShape = false;       // looks for the direction in which a cell is longest: a sphere has none
  bool usesSeed = false;         // draws random numbers
  // Parts that the scene must have, without which the plane could never have an effect
  bool needsContact = false;
  bool needsLongShell = false;  // a shell that is no sphere
  bool needsConnections = false;
  bool keepsPolarity = false;  // its cuts set what polarity daughters inherit [Cut::polarity]
  std::unique_ptr<DivisionPolicy> (*make)(const PlaneChoice&, std::uint64_t seed);
};

/// The rows, each in a file of planes/.
extern const DivisionPlaneKind longestPlane, randomPlane, axisPlane, alternatingPlane, smallestAreaPlane, towardsPlane,
    awayFromPlane, acrossPlane, polarityPlane, shellAxisPlane, perpendicularPlane, parallelPlane, tensionPlane;
/// Returns all rows, in the order in which people should meet them.
std::span<const DivisionPlaneKind> divisionPlanes();
const DivisionPlaneKind& kindOf(DivisionPlane plane);

/// True if a plane that may cut some cells keeps polarities.
bool keepsPolarity(const DivisionParameters& parameters);

/// Returns the chirality of the division of a cell with these substances; absent: its daughters do not turn.
std::optional<Chirality> chiralityOf(const DivisionParameters& parameters, const CellPath& cell,
                                     const std::string& substances);
/// Returns the longest time [time] of all chiralities; 0 without any.
double longestChirality(const DivisionParameters& parameters);

}  // namespace morula
