#pragma once
// The scene of a lineage without bodies, which is computed in no time.
#include "state/scene.h"

namespace morula {

/// Returns true for experiments on bodies: they set a parameter of physics, or connect and release cells.
bool needsBodies(const Experiment& experiment);

/// Returns the scene without bodies. Experiments and conditions that need bodies go with them. If no time ends the run
/// without these conditions, it ends when a run that waits for them would fail (maxCyclesForCells), and the caller
/// limits the cells.
Scene genesAlone(Scene scene);

}  // namespace morula
