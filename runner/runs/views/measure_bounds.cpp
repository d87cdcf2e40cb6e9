#include "views/measure_bounds.h"

#include <algorithm>
#include <string_view>

namespace morula {
namespace {

bool isOneOf(std::string_view row, std::initializer_list<std::string_view> rows) {
  return std::ranges::find(rows, row) != rows.end();
}

/// Calls `use` with the row of a table that the measure takes.
template <class Use>
void withRow(const AskedMeasure& measure, const Use& use) {
  const auto in = [&](const auto& table) {
    for (const auto& row : table)
      if (measure.row == row.name) use(row);
  };
  if (measure.form != AskedMeasure::Form::row) return;
  if (measure.scope == Scope::world) in(measures<Observation>());
  if (measure.scope == Scope::cell) in(measures<CellContext>());
  if (measure.scope == Scope::pair) in(measures<Touch>());
}

}  // namespace

AxisBounds boundsOf(const AskedMeasure& measure, double factor) {
  using Form = AskedMeasure::Form;
  AxisBounds bounds;
  if (measure.form == Form::count || measure.form == Form::distance) bounds.low = 0;
  const std::string_view row = measure.row, unit = measure.unit;
  withRow(measure, [&](const auto& of) {
    const std::string_view meaning = of.meaning;
    if (of.isWhole || unit == "length²" || unit == "length³" || unit == "time") bounds.low = 0;
    if (unit == "length" && !isOneOf(row, {"x", "y", "z"})) bounds.low = 0;
    if (unit == "degree") bounds = {0, 90 * factor};
    if (meaning.starts_with("Share ") ||
        isOneOf(row, {"sphericity", "lumen", "largest_lumen", "contact_jaccard", "contact_f1", "contact_share"}))
      bounds = {0, 1};
    if (isOneOf(row, {"lineage_space", "shell_x", "shell_y", "shell_z"})) bounds = {-1, 1};
    if (isOneOf(row, {"clone_components", "elongation", "organism_elongation", "kinship"})) bounds.low = 1;
    if (isOneOf(row, {"clone_spread", "mixing_index", "neighbours", "kinetic_energy", "shell_fill", "outermost",
                      "position_shape_rmsd", "shell_r", "volume_over_rest", "volume_over_mesh"}))
      bounds.low = 0;
  });
  return bounds;
}

std::string shortMeaningOf(const AskedMeasure& measure) {
  std::string meaning;
  withRow(measure, [&](const auto& of) { meaning = of.meaning; });
  return meaning.substr(0, meaning.find_first_of(";:"));
}

}  // namespace morula
