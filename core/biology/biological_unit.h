#pragma once
// The control of cells, as the simulator sees it [Nilsson 2008, table 4.1]. Implementations are replaceable; the
// logical DNA is one. The simulator asks once per cell and cell cycle, never inside a vertex loop.
#include <string>

#include "base/error.h"
#include "biology/cell_context.h"

namespace morula {

/// All cells whose cycle is due at one instant are asked for their next states before any of them changes. Their wishes
/// are asked at the instant after, when all have changed.
class BiologicalUnit {
 public:
  virtual ~BiologicalUnit() = default;

  /// Returns the egg's state.
  virtual StateId startState() const = 0;
  /// Returns the time from the last cycle (or birth) to the next one, for a cell in this state, at a pace of 1. [time]
  virtual double cycleLength(StateId state) const = 0;
  /// True if the cell's next cell cycle is due: the biological step is much longer than the physical one.
  virtual bool wantsToRunCellCycle(const CellContext& cell) const {
    return cell.time >= cell.lastCycle + cell.pace * cycleLength(cell.state);
  }
  /// Returns the state after one cell cycle.
  virtual StateId runCellCycle(const CellContext& cell) = 0;
  virtual bool wantsToDivide(const CellContext& cell) const = 0;
  virtual bool wantsToDie(const CellContext& cell) const = 0;
  /// > 0: grow; < 0: shrink; 0: neither.
  virtual double wantsToGrow(const CellContext& cell) const = 0;
  /// > 0: connect, < 0: do not; the simulator adds the values of the two cells.
  virtual double wantsToConnect(const CellContext& cell) const = 0;
  /// Returns the state of a daughter: the mother's and one asymmetry substance, A or B.
  virtual StateId daughterState(StateId mother, bool b) = 0;
  /// Switches all genes of this name on or off, in all cells. Throws InputError if there is none.
  virtual void setGene(const std::string& name, bool /*on*/) {
    throw InputError("this biology has no gene '" + name + "' to switch");
  }
  /// The substances of a state, sorted by name, separated by single spaces.
  virtual std::string describe(StateId state) const = 0;
  /// Returns the state with this description, by which a stored cell gets its state back. Throws InputError if no state
  /// can have it; this default always throws.
  virtual StateId stateOf(const std::string& /*description*/) {
    throw InputError("this biology cannot tell states by their descriptions; it needs a stateOf of its own");
  }
};

}  // namespace morula
