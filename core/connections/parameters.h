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

struct ConnectionParameters {
  MakeConnections make = MakeConnections::atDivision;
  ConnectionsOnDivision onDivision = ConnectionsOnDivision::plane;
  double strength = 0.2;  // k_c [force]: constant, towards the other cell [Nilsson 2008, eq. 4.9]
  std::optional<double>
      releaseDistance;  // released when the centres are farther apart, in sums of the two cells' radii
};

}  // namespace morula
