#pragma once
// Experiments in a running world: when the next one is due, what has been done, and doing it.
#include <cstdint>
#include <vector>

#include "base/cell_path.h"
#include "biology/state.h"

namespace morula {

struct World;

/// A deed that was done to a cell, or to all cells alike; a row with `cells` = 0 says that no cell was found.
struct ExperimentRecord {
  std::uint64_t number = 0;  // the place of the experiment in the scene's list, from 1
  double time = 0;           // [time] what the clock showed
  std::uint64_t step = 0;
  std::uint64_t cells = 0;  // 0: none was found; 1: `path`; 2: also `other`; 3: all cells alike
  CellPath path{};
  CellPath other{};
  friend bool operator==(const ExperimentRecord&, const ExperimentRecord&) = default;
};

/// [time] When the next experiment is due that no event makes due: infinite without one. Cells that were born since
/// the last step count.
double nextExperiment(const World& world);

/// Does what is due at this time [time], in the order of the list. Throws NumericalError if no cell that an experiment
/// is for lives then.
void doExperiments(World& world, double time);

/// [1] By how much experiments lengthen the cycles of a cell with this path and state.
double experimentalPace(const World& world, const CellPath& path, StateId state);

/// Brings genes and parameters to what the world's records say that was done. For a state that was restored.
void restoreExperiments(World& world);

}  // namespace morula
