#pragma once
// Experiments in a running world: when the next one is due, what has been done, and doing it.
#include <array>
#include <cstdint>
#include <vector>

#include "base/cell_path.h"
#include "base/choice.h"
#include "biology/state.h"

namespace morula {

struct World;

/// The cells that a deed was done to.
enum class DoneTo { nobody, cell, pair, all };
template <>
inline constexpr auto choices<DoneTo> = std::to_array<Choice<DoneTo>>({
    {DoneTo::nobody, "nobody", "no cell was chosen, or none lives"},
    {DoneTo::cell, "cell", "one cell"},
    {DoneTo::pair, "pair", "the two cells of a connection"},
    {DoneTo::all, "all", "all cells alike"},
});

/// A deed that was done.
struct ExperimentRecord {
  std::uint64_t number = 0;  // the place of the experiment in the scene's list, from 1
  double time = 0;           // [time] what the clock showed
  std::uint64_t step = 0;
  DoneTo to = DoneTo::nobody;
  CellPath path{};   // of the cell, or of one of the pair
  CellPath other{};  // of the other one of the pair
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
