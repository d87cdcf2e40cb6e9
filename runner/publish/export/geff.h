#pragma once
// The tracks of a run as a graph for tracking tools: GEFF 1.2, the Graph Exchange File Format, on Zarr 2
// [https://live-image-tracking-tools.github.io/geff/latest/specification/].
#include "export/tracks.h"
#include "export/zarr.h"

namespace morula {

/// Returns the graph. A node is a spot; its number is the id, its properties are spotFields and `radius`, that of the
/// ball of its volume. An edge leads from a spot to the next one of its track, and from the last one of a cell to the
/// first one of each daughter.
ZarrFolder geffGraph(const ExportedRun& run, const Tracks& tracks);

}  // namespace morula
