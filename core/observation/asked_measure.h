#pragma once
// A measure as people ask for it: in record.measures, in a study, for a chart or for colours. All use one grammar:
//
//   MEASURE               a row of a table, '-' for '_' if one likes: shell_share
//   SCOPE.MEASURE         where rows of two tables have one name: cell.volume
//   MEASURE of SELECTOR   of cells, or of pairs with one of them at least [cell_selection.h]: shell_share of AAA*
//   count of SELECTOR     how many cells these are
//   MEASURE of generation N   of clones: those of the cells N divisions from the egg, clone_radius of generation 3
//   distance S T          between the centres of two selections of cells: distance cell ABa cell P2
//   M / N, M - N          of two of the above, each in the mean over its cells or pairs
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "biology/cell_selection.h"
#include "observation/measures.h"

namespace morula {

struct AskedMeasure {
  enum class Form { row, count, distance, ratio, difference };
  /// The name in results: "sphericity"; with the scope if rows of two tables have the same name: "cell.volume".
  std::string name;
  std::string row;   // name of the row in its table; "" where the form is not row
  std::string unit;  // "length³"; "": a pure number
  Scope scope;       // scope of the row; the organism's for other forms
  Needs needs;
  bool onDemand;                   // taken by takeMeasures; otherwise a column of samples
  bool followsNumber = false;      // as Measure::followsNumber
  bool ofClones = false;           // a measure of the organism's clones
  std::optional<AskedCells> of{};  // absent: of all cells
  Form form = Form::row;
  std::optional<AskedCells> to{};     // the cells to which a distance from `of` is measured
  std::vector<AskedMeasure> parts{};  // the two measures of a ratio or a difference

  /// Returns the measures that have rows, counts or distances of their own: the two parts, or the measure itself.
  std::vector<AskedMeasure> terms() const { return parts.empty() ? std::vector{*this} : parts; }
  /// Returns the title for people, without its unit: "shell share of AAA*", "volume".
  std::string title() const;
};

/// Returns all rows of all tables: world, cell, pair; each in the order of its table.
const std::vector<AskedMeasure>& allMeasures();

/// How readMeasure treats a name that rows of two tables have.
enum class IfSeveral { refuse, first };

/// Reads a measure. Throws InputError "what is wrong; the remedy" for a name that no row has, or rows of two tables,
/// for a selection that is none, and where the measure has no cells to select from.
AskedMeasure readMeasure(const std::string& text, IfSeveral several = IfSeveral::refuse);
/// Reads a measure; absent where readMeasure throws.
std::optional<AskedMeasure> findMeasure(const std::string& text);

/// Returns the ratio or the difference of two values; absent if one of them is, or if the divisor is 0.
std::optional<double> combined(AskedMeasure::Form form, std::optional<double> a, std::optional<double> b);

/// Replaces each selection of cells in the measure by what `replace` makes of it; the name follows.
AskedMeasure withSelections(AskedMeasure measure, const std::function<AskedCells(const AskedCells&)>& replace);

/// Returns one measure for each clone, AA*, AB*, BA*, BB*, if `measure` is "of clones"; otherwise the measure itself.
std::vector<AskedMeasure> eachClone(const AskedMeasure& measure);

/// Returns what is wrong, and what was probably meant, if the measure selects cells that hold a substance and none of
/// `substances`, all that ever occur, is that substance. Otherwise returns "".
std::string unknownSubstance(const AskedMeasure& measure, const std::vector<std::string>& substances);

}  // namespace morula
