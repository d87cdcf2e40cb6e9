#pragma once
// The scene of a lineage without bodies, which is computed in no time.
#include "state/scene.h"

namespace morula {

/// Returns the scene without bodies. Conditions that need bodies go with them; if no time ends the run then, it ends
/// when a run that waits for its conditions would fail (maxCyclesForCells), and the caller limits the cells.
Scene genesAlone(Scene scene);

}  // namespace morula
