#include "store/sample_values.h"

#include <set>

namespace morula {
namespace {

using States = std::map<StateId, std::string>;

std::set<CellPath> selectedCells(const Sample& sample, const std::optional<AskedCells>& cells, const States& states) {
  std::set<CellPath> selected;
  if (cells)
    for (const CellMeasures& c : sample.cells)
      if (cells->has(c.path, states.at(c.state))) selected.insert(c.path);
  return selected;
}

/// Returns the mean centre [length] of the selected cells; absent if the sample holds none.
std::optional<Point> centreOf(const Sample& sample, const std::optional<AskedCells>& cells, const States& states) {
  Point sum{};
  int count = 0;
  for (const CellMeasures& c : sample.cells)
    if (cells->has(c.path, states.at(c.state)) && c["x"]) sum += Point{c.at("x"), c.at("y"), c.at("z")}, ++count;
  return count > 0 ? std::optional<Point>(sum / static_cast<double>(count)) : std::nullopt;
}

/// Returns the value of a measure that is no row of a table.
std::optional<double> valueOf(const Sample& sample, const AskedMeasure& measure, const States& states) {
  using Form = AskedMeasure::Form;
  if (measure.form == Form::count) {
    if (sample.cells.empty()) return std::nullopt;
    return static_cast<double>(selectedCells(sample, measure.of, states).size());
  }
  if (measure.form != Form::distance)
    return combined(measure.form, meanIn(sample, measure.parts[0], states), meanIn(sample, measure.parts[1], states));
  const auto from = centreOf(sample, measure.of, states), to = centreOf(sample, measure.to, states);
  return from && to ? std::optional(norm(*from - *to)) : std::nullopt;
}

}  // namespace

std::map<MeasuredThing, double> valuesIn(const Sample& sample, const AskedMeasure& measure,
                                         const std::map<StateId, std::string>& states) {
  std::map<MeasuredThing, double> values;
  for (const TakenMeasure& taken : sample.more)
    if (taken.name == measure.name) values[{taken.a, taken.b}] = taken.value;
  if (!values.empty()) return values;
  if (measure.form != AskedMeasure::Form::row) {
    if (const auto value = valueOf(sample, measure, states)) values[{}] = *value;
    return values;
  }
  const std::set<CellPath> selected = selectedCells(sample, measure.of, states);
  const auto add = [&](const CellPath& a, const CellPath& b, const std::optional<double>& value) {
    if (value && (!measure.of || selected.contains(a) || (measure.scope == Scope::pair && selected.contains(b))))
      values[{a, b}] = *value;
  };
  if (measure.onDemand) {
    if (!measure.ofClones)
      for (const TakenMeasure& taken : sample.more)
        if (taken.name == measure.row) add(taken.a, taken.b, taken.value);
  } else if (measure.scope == Scope::world) {
    add({}, {}, sample.world[measure.row]);
  } else if (measure.scope == Scope::cell) {
    for (const CellMeasures& cell : sample.cells) add(cell.path, {}, cell[measure.row]);
  } else {
    for (const ContactMeasures& pair : sample.contacts) add(pair.a, pair.b, pair[measure.row]);
  }
  return values;
}

std::optional<double> meanIn(const Sample& sample, const AskedMeasure& measure,
                             const std::map<StateId, std::string>& states) {
  double sum = 0;  // in the order of paths
  const auto values = valuesIn(sample, measure, states);
  for (const auto& [thing, value] : values) sum += value;
  return values.empty() ? std::nullopt : std::optional(sum / static_cast<double>(values.size()));
}

}  // namespace morula
