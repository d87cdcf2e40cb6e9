#pragma once
// A measure as people ask for it, wherever one may stand: in record.measures and in a study, for a chart and for
// colours. One grammar:
//
//   MEASURE               a row of a table, '-' for '_' if one likes: shell_share
//   SCOPE.MEASURE         where rows of two tables have one name: cell.volume
//   MEASURE of SELECTOR   of cells, or of pairs with one of them at least [cell_selection.h]: shell_share of AAA*
//   count of SELECTOR     how many cells these are
//   MEASURE of generation N   of clones: those of the cells N divisions from the egg, clone_radius of generation 3
#include <optional>
#include <string>
#include <vector>

#include "simulation/cell_selection.h"
#include "simulation/measures.h"

namespace morula {

struct AskedMeasure {
  /// The name in results: "sphericity"; with its scope if rows of two tables have the same name: "cell.volume".
  std::string name;
  std::string row;   // in its table
  std::string unit;  // "length³"; "": a pure number
  Scope scope;       // of a count: the organism's
  Needs needs;
  bool onDemand;                      // taken by takeMeasures; otherwise a column of samples
  bool followsNumber = false;         // as Measure
  bool ofClones = false;              // of the organism's clones
  std::optional<CellSelection> of{};  // absent: of all cells

  /// How many cells are selected: no row of a table.
  bool isCount() const { return row.empty(); }
  /// The title for people, without its unit: "shell share of AAA*", "volume".
  std::string title() const;
};

/// All rows of all tables: world, cell, pair; each in the order of its table.
const std::vector<AskedMeasure>& allMeasures();

/// How findMeasure treats a name that rows of two tables have.
enum class IfSeveral { refuse, first };

/// Reads it. Throws InputError "what is wrong; the remedy" for a name that no row has, or those of two tables, for a
/// selection that is none, and where the measure has no cells to select from.
AskedMeasure readMeasure(const std::string& text, IfSeveral several = IfSeveral::refuse);
/// Absent instead.
std::optional<AskedMeasure> findMeasure(const std::string& text);

/// One for each clone where `measure` is "of clones": of AA*, AB*, BA*, BB*. Otherwise itself.
std::vector<AskedMeasure> eachClone(const AskedMeasure& measure);

/// "" unless it is of cells that hold a substance, and it is none of these, all that ever occur; otherwise what is
/// wrong, and what was probably meant.
std::string unknownSubstance(const AskedMeasure& measure, const std::vector<std::string>& substances);

}  // namespace morula
