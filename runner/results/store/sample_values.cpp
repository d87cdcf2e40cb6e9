#include "store/sample_values.h"

#include <set>

namespace morula {

std::map<MeasuredThing, double> valuesIn(const Sample& sample, const AskedMeasure& measure,
                                         const std::map<StateId, std::string>& states) {
  std::map<MeasuredThing, double> values;
  for (const TakenMeasure& taken : sample.more)
    if (taken.name == measure.name) values[{taken.a, taken.b}] = taken.value;
  if (!values.empty()) return values;
  std::set<CellPath> selected;
  if (measure.of)
    for (const CellMeasures& c : sample.cells)
      if (measure.of->has(c.path, states.at(c.state))) selected.insert(c.path);
  if (measure.isCount()) {
    if (!sample.cells.empty()) values[{}] = static_cast<double>(selected.size());
    return values;
  }
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

}  // namespace morula
