#pragma once
// The parameters of connections between cells [Nilsson 2008, §4.4.3].
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/choice.h"
#include "base/members.h"

namespace morula {

enum class MakeConnections { atDivision, byGene, both, byContact, pairs };
template <>
inline constexpr auto choices<MakeConnections> = std::to_array<Choice<MakeConnections>>({
    {MakeConnections::atDivision, "at-division", "sisters at birth"},
    {MakeConnections::byGene, "by-gene", "neighbours whose genes produce connect, at their cell cycles"},
    {MakeConnections::both, "both", "either"},
    {MakeConnections::byContact, "by-contact", "neighbours whose genes do not produce release, at their cell cycles"},
    {MakeConnections::pairs, "pairs", "such neighbours with one of the given pairs of substances"},
});

/// The daughters that inherit a dividing cell's connections.
enum class ConnectionsOnDivision { plane, both, nearest, a };
template <>
inline constexpr auto choices<ConnectionsOnDivision> = std::to_array<Choice<ConnectionsOnDivision>>({
    {ConnectionsOnDivision::plane, "plane", "each to the daughter on its side of the plane"},
    {ConnectionsOnDivision::both, "both", "all to both daughters"},
    {ConnectionsOnDivision::nearest, "nearest", "each to the daughter whose centre is nearer"},
    {ConnectionsOnDivision::a, "a", "all to daughter A, as an old cell keeps its bridges"},
});

// [force] In eq. 4.9 each connection pulls with k_c, however many a cell has, and daughters pull as hard as their
// mother: 32 cells that all hold one another press a tissue of radius R with 32²/2 · k_c · R. Shares of one strength,
// which divides as the egg does, press with no more than an egg's worth, in any number.
constexpr double sharedStrength = 0.2;

/// Cells that connect when they touch: one holds a substance that fits `a`, the other one that fits `b`.
struct ConnectedPair {
  std::string a, b;  // a substance, or its beginning and '*'
};
MORULA_MEMBERS(ConnectedPair, first, second)

/// A connection that pulls and pushes along the centres: k (d − rest (r_1 + r_2)).
struct ConnectionSpring {
  double stiffness = 2;  // k [force/length]; higher: centres closer to their distance at rest
  double rest = 1;       // [1] distance of the centres at rest, in sums of the two cells' radii
};
MORULA_MEMBERS(ConnectionSpring, stiffness, rest)

struct ConnectionParameters {
  MakeConnections make = MakeConnections::atDivision;
  ConnectionsOnDivision onDivision = ConnectionsOnDivision::plane;
  // k_c [force] of each connection: constant, towards the other cell [Nilsson 2008, eq. 4.9]. Absent: all
  // connections of a cell together pull with at most `sharedStrength`, times its share of the egg.
  std::optional<double> strength;
  std::optional<double> releaseDistance;        // max distance of the centres, in sums of the two cells' radii
  std::vector<ConnectedPair> pairs = {};        // for MakeConnections::pairs
  std::optional<ConnectionSpring> spring = {};  // instead of a constant pull
  std::optional<double> releaseTension = {};    // [force] max pull of a spring
  std::optional<double> releaseAge = {};        // [time] max age
  std::optional<std::uint64_t> most = {};       // max number of a cell's connections
};
MORULA_MEMBERS(ConnectionParameters, make, onDivision, strength, releaseDistance, pairs, spring, releaseTension,
                                     releaseAge, most)

}  // namespace morula
