#pragma once
// What a scenario may say about connections between cells [Nilsson 2008, §4.4.3].
#include <optional>

#include "base/choice.h"

namespace morula {

enum class MakeConnections { atDivision, byGene, both };
template <>
inline constexpr auto choices<MakeConnections> = std::to_array<Choice<MakeConnections>>({
    {MakeConnections::atDivision, "at-division", "sisters at birth"},
    {MakeConnections::byGene, "by-gene", "neighbours whose genes produce connect, at their cell cycles"},
    {MakeConnections::both, "both", "either"},
});

/// Where a dividing cell's connections go.
enum class ConnectionsOnDivision { plane, both };
template <>
inline constexpr auto choices<ConnectionsOnDivision> = std::to_array<Choice<ConnectionsOnDivision>>({
    {ConnectionsOnDivision::plane, "plane", "each to the daughter on its side of the plane"},
    {ConnectionsOnDivision::both, "both", "all to both daughters"},
});

// [force] Eq. 4.9 pulls with k_c per connection, however many a cell has, and its daughters as hard as their
// mother: 32 cells that all hold one another press a tissue of radius R with 32²/2 · k_c · R. Shares of one
// strength, that divide as the egg does, press with no more than an egg's worth, in any number.
constexpr double sharedStrength = 0.2;

struct ConnectionParameters {
  MakeConnections make = MakeConnections::atDivision;
  ConnectionsOnDivision onDivision = ConnectionsOnDivision::plane;
  // k_c [force] of each connection: constant, towards the other cell [Nilsson 2008, eq. 4.9]. Absent: all
  // connections of a cell together pull with at most `sharedStrength`, times its share of the egg.
  std::optional<double> strength;
  std::optional<double> releaseDistance;  // of the centres, in sums of the two cells' radii; released beyond
};

}  // namespace morula
