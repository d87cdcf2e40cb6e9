#pragma once
// A lineage-only organism as in the thesis: all cells run their cycle together, then divide or die.
#include <map>
#include <memory>
#include <string>

#include "biology/biological_unit.h"
#include "biology/dna.h"
#include "biology/logical_dna.h"

namespace morula {

class Organism {
 public:
  explicit Organism(const std::string& dna) : unit_(makeLogicalDna(parseDna(dna, "test.dna"), {})) {
    cells_ = {{CellPath{}, unit_->startState()}};
  }

  void runCellCycle() {
    std::map<CellPath, StateId> next;
    for (const auto& [path, state] : cells_) {
      CellContext cell;
      cell.path = path;
      cell.state = state;
      cell.state = unit_->runCellCycle(cell);
      if (unit_->wantsToDie(cell)) continue;
      if (unit_->wantsToDivide(cell))
        for (bool b : {false, true}) next[path.daughter(b)] = unit_->daughterState(cell.state, b);
      else next[path] = cell.state;
    }
    cells_ = std::move(next);
  }

  /// Returns path → substances.
  std::map<std::string, std::string> cells() const {
    std::map<std::string, std::string> all;
    for (const auto& [path, state] : cells_) all[path.text()] = unit_->describe(state);
    return all;
  }

  /// Returns how many cells hold which substances.
  std::map<std::string, int> census() const {
    std::map<std::string, int> count;
    for (const auto& [path, state] : cells_) ++count[unit_->describe(state)];
    return count;
  }

  std::size_t size() const { return cells_.size(); }

 private:
  std::unique_ptr<BiologicalUnit> unit_;
  std::map<CellPath, StateId> cells_;
};

}  // namespace morula
