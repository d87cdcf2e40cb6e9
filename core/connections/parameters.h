#pragma once
// What a scenario may say about connections between cells [Nilsson 2008, §4.4.3].
#include <optional>

namespace morula {

enum class MakeConnections {
  atDivision,  // sisters are connected at birth
  byGene,      // neighbours whose summed wantsToConnect is positive, at their cell cycles
  both,
};

enum class ConnectionsOnDivision {
  plane,  // the plane decides: a connection goes to the daughter on whose side the other cell lies
  both,   // both daughters keep every connection; `releaseDistance` or their genes end it
};

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
  std::optional<double>
      releaseDistance;  // released when the centres are farther apart, in sums of the two cells' radii
};

}  // namespace morula
