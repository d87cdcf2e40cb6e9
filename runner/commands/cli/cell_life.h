#pragma once
// One cell's life out of a tree of cells, for people and for programs.
#include <map>
#include <string>

#include "store/records.h"
#include "system/json.h"
#include "values/cell_names.h"
#include "values/units.h"

namespace morula::cli {

/// A cell of a run, with its relatives. The run must outlive it.
struct CellLife {
  const LineageEntry* cell;
  const LineageEntry *mother, *sister;           // null: it has none
  const LineageEntry *daughterA, *daughterB;     // null: it did not divide
  const std::string& state;                      // its substances
  const std::map<CellPath, std::string>& names;  // of the cells of the tree that have one
  double end;                                    // [time] of the run
};

/// The cell that `text` means by name or path [cellCalled]. Throws UsageError that begins with "--cell" if it means
/// none, or one that the run, which ended at `end` [time], never had.
CellLife lifeOf(const RunResults& tree, double end, const CellNames& names, const std::string& text);

/// A line for each of path, name, born, ended, fate, state, mother, daughters and sister; what it does not have has none.
std::string lifeAsText(const CellLife& life, const Units& units);
/// The same: "path", "name", "parent", "born", "ended", "fate" and "state" as a cell of the whole tree; "mother" and
/// "sister" as {"path", "name"}, or null; "daughters", a list of such.
Json lifeAsJson(const CellLife& life);

/// A cell of the whole tree: "path", "name", "parent", "born", "ended", "fate", "state". The `ended` of a living one is
/// the run's end.
Json cellAsJson(const LineageEntry& cell, const std::map<CellPath, std::string>& names, const std::string& state,
                double end);

}  // namespace morula::cli
