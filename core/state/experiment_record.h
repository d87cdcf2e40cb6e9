#pragma once
// The records of experiments that were done in a world, and of the cells that they were done to.
#include <array>
#include <cstdint>
#include <vector>

#include "base/cell_path.h"
#include "base/choice.h"
#include "biology/state.h"
#include "state/experiment.h"

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

/// Returns true if the experiment with this number has been done.
bool wasDone(const World& world, std::uint64_t number);
/// Returns true if the experiment with this number has been done to the cell.
bool wasDoneTo(const World& world, std::uint64_t number, const CellPath& path);
/// Returns true if the experiment is for cells with this path and state.
bool selects(const Experiment& experiment, const World& world, const CellPath& path, StateId state);
/// Returns true if the cell is among the share of cells that the seed chooses.
bool isChosen(const Experiment& experiment, const World& world, std::uint64_t number, const CellPath& path);

}  // namespace morula
