#pragma once
// The measures that a study may take: all rows of the tables of measures, by names that belong to one row each, and those of
// cells and pairs also of some cells alone: "shell_share of AAA*", "count of skin".
#include <optional>
#include <string>
#include <vector>

#include "simulation/measures.h"
#include "study/cell_selection.h"

namespace morula {

struct StudyMeasure {
  /// As results call it: "sphericity"; where rows of two tables have one name, with its scope: "cell.volume".
  std::string name;
  std::string row;   // in its table
  std::string unit;  // "length³"; "": a pure number
  Scope scope;
  Needs needs;
  bool onDemand;                      // taken by takeMeasures; otherwise a column of samples
  std::optional<CellSelection> of{};  // absent: of all cells

  /// How many cells are selected: no row of a table.
  bool isCount() const { return row.empty(); }
};

/// World, cell, pair; each in the order of its table.
const std::vector<StudyMeasure>& studyMeasures();

/// By its name in a study; '-' may stand for '_', and a scope may stand before any name. A measure of cells (the mean over
/// them) or pairs (over those with one of them at least) may have "of" and a selection behind it, and "count of" counts the
/// cells. Absent if there is none, or if rows of two tables have that name. Throws InputError for a selection that is none, and
/// where the measure has no cells to select from.
std::optional<StudyMeasure> findStudyMeasure(const std::string& text);

}  // namespace morula
