#pragma once
// A bench report as text.
#include <string>

#include "bench/bench.h"

namespace morula {

std::string describe(const BenchReport& report);

}  // namespace morula
