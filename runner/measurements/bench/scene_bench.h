#pragma once
// All rows of one packed scene: which measurements it calls for, taken in turn, round after round.
#include "bench/bench.h"
#include "bench/packed_world.h"

namespace morula {

struct PlannedScene {
  PackedScene packed;
  std::string name;
  bool whole;  // with everything beside it; else only what this variant of a scene changes
};

/// From packing to the last round, all rows but for their shares of the machine's limits; `meter` is read in
/// every round. Only one scene is in memory at a time.
std::vector<BenchRow> measureScene(const PlannedScene& scene, const BenchOptions& options, LimitMeter& meter);

}  // namespace morula
