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

// [force] Eq. 4.9 pulls with k_c per connection, however many a cell has, and its daughters as hard as their
// mother: 32 cells that all hold one another press a tissue of radius R with 32²/2 · k_c · R. Shares of one
// strength, that divide as the egg does, press with no more than an egg's worth, in any number.
constexpr double sharedStrength = 0.2;

/// Cells that connect when they touch: one holds a substance that fits `a`, the other one that fits `b`.
struct ConnectedPair {
  std::string a, b;  // a substance, or the beginning of some and '*'
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
  std::optional<double> releaseDistance;        // of the centres, in sums of the two cells' radii; released beyond
  std::vector<ConnectedPair> pairs = {};        // of MakeConnections::pairs
  std::optional<ConnectionSpring> spring = {};  // instead of a constant pull
  std::optional<double> releaseTension = {};    // [force] with which a spring pulls; released above
  std::optional<double> releaseAge = {};        // [time] since it was made; released then
  std::optional<std::uint64_t> most = {};       // of a cell's connections: one more is not made
};
MORULA_MEMBERS(ConnectionParameters, make, onDivision, strength, releaseDistance, pairs, spring, releaseTension,
                                     releaseAge, most)

}  // namespace morula
