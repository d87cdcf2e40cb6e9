#pragma once
// How much there is to do per vertex and step, counted from the formulas and not from any code: what a kernel
// is measured against. Operations are multiplications, additions and subtractions of doubles; square roots
// and divisions come extra, as pairs; bytes are those that must come from or go to memory once the state does
// not stay in a cache.
#include "bench/machine_limits.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

struct Work {
  double operations = 0, roots = 0, bytes = 0;
  friend Work operator+(const Work& a, const Work& b) {
    return {a.operations + b.operations, a.roots + b.roots, a.bytes + b.bytes};
  }
};

/// Springs, volume and its gradient, pressure, drag.
Work internalWork(const MeshTemplate& mesh, const PhysicsParameters& physics);
/// Snapshots and pair forces; `pairs`: pairs in reach of a vertex's list, seen from it.
Work contactWork(double pairs, bool friction);
/// Drift, shell, kick.
Work integrationWork(bool shell);
/// All of them in two passes over memory, or one without contact.
Work stepWork(const Work& internal, const Work& contact, const Work& integration, double pairs,
              bool touching);

/// [byte] per vertex of a scene's state, in which each step goes to and fro.
double footprint(double pairs, bool touching);

/// [s] per vertex and step that the machine needs at least, with all its units busy at once. `cells` and
/// `vertices` decide which memory it is.
double leastTime(const Work& work, const MachineLimits& limits, Isa isa, double bytesInAll);

}  // namespace morula
