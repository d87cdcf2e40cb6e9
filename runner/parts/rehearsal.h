#pragma once
// The beginning of a run, made in earnest, to see what it will be like: a scene's own cells, steps and
// contacts instead of assumptions about them. What is counted is the same on every machine.
#include <cstdint>
#include <vector>

#include "parts/life.h"
#include "simulation/world.h"

namespace morula {

/// What was done in one era.
struct Stretch {
  std::uint64_t steps = 0, rebuilds = 0;
  std::uint64_t pairs = 0;  // evaluations of a vertex and a neighbour
  double until = 0;         // [time]
};

struct Rehearsal {
  World world;                     // as it was left
  std::vector<Stretch> stretches;  // one for each era that it came to; the last may be unfinished
  bool whole = false;              // it came to the run's end
  double seconds = 0;              // [s] of CPU time, all steps
  // Of these, the steps in which cells were born or died, and the cells that were there then, added up.
  double upheavalSeconds = 0;
  std::uint64_t upheavalCells = 0;
  // After the last of them: up to which a time step was stable, and the divisions before the youngest cell.
  double timeStepLimit = 0;
  int generation = 0;

  const Stretch& last() const { return stretches.back(); }
};

/// Runs the scene for about so many steps times vertices. `world` is new. Throws NumericalError as a run
/// would.
Rehearsal rehearse(World world, const Life& life, double vertexSteps = 8e6);

}  // namespace morula
