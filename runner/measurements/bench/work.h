#pragma once
// How much there is to do per vertex and step, counted from the formulas and not from any code: what a kernel
// is measured against. Operations are multiplications, additions and subtractions of doubles; square roots
// and divisions come extra, as pairs. Bytes are those that must come from memory or go there, once per pass
// over all cells; what a stage touches in all decides which cache they can come from.
#include "bench/machine_limits.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

struct Work {
  double operations = 0, roots = 0, bytes = 0;
  double touched = 0;  // [byte] per vertex
};

/// Springs, volume and its gradient, pressure, drag.
Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Which share of it is for the springs. [1]
double springShare(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Snapshots and pair forces; `pairs`: entries in a vertex's list.
Work contactWork(double pairs, bool friction);
/// Drift, shell, kick.
Work integrationWork(bool shell);
/// All of them: two passes over memory, or one without contact (null).
Work stepWork(const Work& internal, const Work* contact, const Work& integration);

/// [s] per vertex and step that the machine needs at least, with all its units busy at once. `vertices`: of all cells.
double minTime(const Work& work, const MachineLimits& limits, Isa isa, double vertices);

}  // namespace morula
