#pragma once
// A bench report as a picture: time per vertex and step over the number of cells, both on logarithmic scales.
#include "bench/bench.h"
#include "image/image.h"

namespace morula {

/// One line per engine and instruction set, for whole steps of packed cells of 162 vertices; the thesis' own
/// times, scaled so that 8 cells cost as much as ours.
Image drawBench(const BenchReport& report);

}  // namespace morula
