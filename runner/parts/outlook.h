#pragma once
// From the eras that were rehearsed to those that were not.
#include <optional>
#include <vector>

#include "parts/memory.h"
#include "parts/rehearsal.h"

namespace morula {

/// What an era will have counted in the end.
struct Outlook {
  double steps = 0, searches = 0, pairs = 0;
};

/// How cells differ from equal parts of a free egg.
struct CellTrend {
  double lightness = 1;    // mass of the lighter daughter over half her mother's
  double compression = 1;  // volume over that of the same contents in the egg
};
CellTrend measureTrend(const World& world);

/// [time] The step of the lightest cells after so many divisions; none with a fixed step that would be above
/// their limit.
std::optional<double> foretellTimeStep(const Scene& scene, int generation, const CellTrend& trend);

/// One for each era of a life with bodies.
std::vector<Outlook> lookAhead(const Life& life, const Rehearsal& rehearsal);

/// When so many live. Exact for a rehearsal that came to its end with them.
MemoryUse foretellMemory(const Life& life, const Rehearsal& rehearsal);

}  // namespace morula
