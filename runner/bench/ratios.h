#pragma once
// What the project has promised itself, read off a finished table.
#include "bench/bench.h"

namespace morula {

/// Those whose rows are there.
std::vector<BenchRatio> findRatios(const std::vector<BenchRow>& rows);

}  // namespace morula
