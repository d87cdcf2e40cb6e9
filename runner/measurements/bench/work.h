#pragma once
// The work per vertex and step, counted from the formulas and not from code: the measure of a kernel. Operations are
// multiplications, additions and subtractions of doubles; square roots and divisions count separately, as pairs. Bytes
// are those moved from or to memory, once per pass over all cells. All memory that a stage uses decides the cache that
// holds it.
#include "bench/machine_limits.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

struct Work {
  double operations = 0, roots = 0, bytes = 0;
  double touched = 0;  // [byte] memory used, per vertex
};

/// Returns the work of springs, volume and its gradient, pressure, drag.
Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Returns the springs' share of internalWork [1].
double springShare(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Returns the work of snapshots and pair forces. `pairs`: entries in a vertex's list.
Work contactWork(double pairs, bool viscosity);
/// Returns the work of drift, shell, kick.
Work integrationWork(bool shell);
/// Returns the work of a whole step: two passes over memory, or one without contact (null).
Work stepWork(const Work& internal, const Work* contact, const Work& integration);

/// Returns the machine's least time per vertex and step [s], with all its units busy at once. `vertices`: of all cells.
double minTime(const Work& work, const MachineLimits& limits, Isa isa, double vertices);

}  // namespace morula
