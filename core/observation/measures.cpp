// Takes measures. Their rows: measures_world.cpp, measures_cell.cpp, measures_pair.cpp.

#include "observation/measures.h"

#include <algorithm>

#include "base/error.h"
#include "observation/asked_measure.h"
#include "physics/bodies.h"

namespace morula {

bool canMeasure(const Observation& now, Needs needs) {
  const World& world = now.world;
  switch (needs) {
    case Needs::nothing: return true;
    case Needs::shell: return world.bodies && world.bodies->parameters.shell;
    case Needs::bodies:
    case Needs::contact:  // without contact no cells touch: 0, not unknown
      return world.bodies.has_value();
    case Needs::referenceContacts: return world.bodies && now.reference && !now.reference->contacts.empty();
    case Needs::referencePositions: return world.bodies && now.reference && !now.reference->positions.empty();
  }
  MORULA_CHECK(false, "a need that is not known");
}

namespace {

template <class Of>
void take(const Observation& now, const Of& of, Measured<Of>& into) {
  const auto rows = sampledMeasures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (canMeasure(now, rows[i].needs)) into.values[i] = rows[i].get(of);
}

}  // namespace

const char* name(Needs needs) {
  constexpr const char* names[] = {
      "nothing", "bodies", "contact", "a shell", "check.reference.contacts", "check.reference.positions"};
  return names[static_cast<int>(needs)];
}

const char* name(Scope scope) {
  constexpr const char* names[] = {"world", "cell", "pair"};
  return names[static_cast<int>(scope)];
}

template <class Of>
std::span<const Measure<Of>> sampledMeasures() {
  const auto all = measures<Of>();
  const auto end = std::ranges::find(all, Taken::onDemand, &Measure<Of>::taken);
  return all.first(end - all.begin());
}

template <class Of>
const Measure<Of>& measure(std::string_view name) {
  const auto all = measures<Of>();
  const auto at = std::ranges::find(all, name, &Measure<Of>::name);
  MORULA_CHECK(at != all.end(), "a measure that no row names");
  return *at;
}

template <class Of>
std::size_t Measured<Of>::indexOf(std::string_view name) {
  const auto rows = sampledMeasures<Of>();
  const auto at = std::ranges::find(rows, name, &Measure<Of>::name);
  MORULA_CHECK(at != rows.end(), "a measure that samples do not hold");
  return at - rows.begin();
}

template <class Of>
double Measured<Of>::at(std::string_view name) const {
  const std::optional<double>& value = values[indexOf(name)];
  MORULA_CHECK(value.has_value(), "a value that was not measured");
  return *value;
}

#define MORULA_MEASURES_OF(Of)                             \
  template std::span<const Measure<Of>> sampledMeasures(); \
  template const Measure<Of>& measure(std::string_view);   \
  template class Measured<Of>;
MORULA_MEASURES_OF(Observation)
MORULA_MEASURES_OF(CellContext)
MORULA_MEASURES_OF(Touch)
#undef MORULA_MEASURES_OF

WorldMeasures measureWorld(const Observation& now) {
  WorldMeasures m;
  m.time = now.time;
  m.step = now.world.clock.step;
  take(now, now, m);
  return m;
}

std::vector<CellMeasures> measureCells(const Observation& now) {
  std::vector<CellMeasures> all;
  if (!now.world.bodies) return all;
  for (int i = 0; i < now.world.bodies->count; ++i) {
    const ObservedCell cell(now, i);
    CellMeasures& m = all.emplace_back();
    m.path = cell.path;
    m.state = cell.state;
    take<CellContext>(now, cell, m);
  }
  return all;
}

std::vector<ContactMeasures> measureContacts(const Observation& now) {
  std::vector<ContactMeasures> all;
  for (const auto& [a, b, area] : now.contacts()) {
    ContactMeasures& m = all.emplace_back();
    const Touch touch{now.cell(a), now.cell(b), area};
    m.a = touch.a.path;
    m.b = touch.b.path;
    take(now, touch, m);
  }
  return all;
}

namespace {

template <class Of>
void describeRows(Scope scope, std::vector<MeasureOnDemand>& all) {
  for (const Measure<Of>& row : measures<Of>())
    if (row.taken == Taken::onDemand) all.push_back({scope, row.name, row.needs});
}

/// True for each living cell that is selected, [cell]; empty: all are.
using Selected = std::vector<char>;

Selected selectedCells(const Observation& now, const std::optional<AskedCells>& cells) {
  Selected selected;
  if (!cells) return selected;
  const auto& paths = now.world.cells.path;
  for (int i = 0; i < static_cast<int>(paths.size()); ++i)
    selected.push_back(cells->has(paths[i], now.world.biology->describe(now.world.cells.state[i])));
  return selected;
}

bool has(const Selected& selected, int cell) { return selected.empty() || selected[cell]; }

/// A measure of cells or pairs that was asked for.
template <class Of>
struct AskedRow {
  const Measure<Of>* row;
  const std::string* name;
  Selected selected;
};

/// Takes a measure of one thing, and adds nothing if there is nothing to measure.
template <class Of>
void takeOne(const Observation& now, const AskedRow<Of>& asked, Scope scope, const CellPath& a, const CellPath& b,
             const Of& of, std::vector<TakenMeasure>& taken) {
  if (!canMeasure(now, asked.row->needs)) return;
  if (const std::optional<double> value = asked.row->get(of)) taken.push_back({scope, *asked.name, a, b, *value});
}

/// Returns the mean of all values that a measure has; absent if it has none.
std::optional<double> meanOf(const Observation& now, const AskedMeasure& asked) {
  double sum = 0;  // in the order of paths
  const std::vector<TakenMeasure> taken = takeMeasures(now, {&asked.name, 1});
  for (const TakenMeasure& one : taken) sum += one.value;
  return taken.empty() ? std::nullopt : std::optional(sum / static_cast<double>(taken.size()));
}

/// Returns the mean of the centres [length] of the selected cells; absent if no such cell lives.
std::optional<Point> centreOf(const Observation& now, const Selected& selected) {
  Point sum{};
  int count = 0;
  for (int i = 0; i < static_cast<int>(selected.size()); ++i)
    if (selected[i]) sum += now.centreOf(i), ++count;
  return count > 0 ? std::optional<Point>(sum / static_cast<double>(count)) : std::nullopt;
}

std::optional<double> valueOf(const Observation& now, const AskedMeasure& asked) {
  using Form = AskedMeasure::Form;
  switch (asked.form) {
    case Form::count: return std::ranges::count(selectedCells(now, asked.of), 1);
    case Form::distance: {
      const auto from = centreOf(now, selectedCells(now, asked.of)), to = centreOf(now, selectedCells(now, asked.to));
      return from && to ? std::optional(norm(*from - *to)) : std::nullopt;
    }
    case Form::ratio:
    case Form::difference: return combined(asked.form, meanOf(now, asked.parts[0]), meanOf(now, asked.parts[1]));
    case Form::row: break;
  }
  const WorldMeasure& row = measure<Observation>(asked.row);
  return asked.of ? row.ofClones(now, asked.of->generation) : row.get(now);
}

void takeOfWorld(const Observation& now, const AskedMeasure& asked, std::vector<TakenMeasure>& taken) {
  if (!canMeasure(now, asked.needs)) return;
  if (const auto value = valueOf(now, asked)) taken.push_back({Scope::world, asked.name, {}, {}, *value});
}

void takeOfCells(const Observation& now, const std::vector<AskedRow<CellContext>>& rows,
                 std::vector<TakenMeasure>& taken) {
  if (rows.empty()) return;
  for (int i = 0; i < static_cast<int>(now.world.cells.path.size()); ++i) {
    const ObservedCell cell(now, i);  // made anew, so that only one shape is in memory at a time
    for (const auto& row : rows)
      if (has(row.selected, i)) takeOne<CellContext>(now, row, Scope::cell, cell.path, {}, cell, taken);
  }
}

void takeOfPairs(const Observation& now, const std::vector<AskedRow<Touch>>& rows, std::vector<TakenMeasure>& taken) {
  if (rows.empty()) return;
  const std::vector<ContactArea>& contacts = now.contacts();
  const std::span<const double> durations = now.contactDurations;
  MORULA_CHECK(durations.empty() || durations.size() == contacts.size(), "one duration for each contact");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b, area] = contacts[i];
    const Touch touch{now.cell(a), now.cell(b), area, durations.empty() ? std::nullopt : std::optional(durations[i])};
    for (const auto& row : rows)
      if (has(row.selected, a) || has(row.selected, b))
        takeOne(now, row, Scope::pair, touch.a.path, touch.b.path, touch, taken);
  }
}

}  // namespace

std::vector<MeasureOnDemand> measuresOnDemand() {
  std::vector<MeasureOnDemand> all;
  describeRows<Observation>(Scope::world, all);
  describeRows<CellContext>(Scope::cell, all);
  describeRows<Touch>(Scope::pair, all);
  return all;
}

std::vector<TakenMeasure> takeMeasures(const Observation& now, std::span<const std::string> names) {
  std::vector<TakenMeasure> taken;
  std::vector<AskedRow<CellContext>> ofCells;
  std::vector<AskedRow<Touch>> ofPairs;
  for (const std::string& name : names) {
    const std::optional<AskedMeasure> asked = findMeasure(name);
    MORULA_CHECK(asked.has_value(), "a measure that no row names");
    if (asked->scope == Scope::world) takeOfWorld(now, *asked, taken);
    else if (asked->scope == Scope::cell)
      ofCells.push_back({&measure<CellContext>(asked->row), &name, selectedCells(now, asked->of)});
    else ofPairs.push_back({&measure<Touch>(asked->row), &name, selectedCells(now, asked->of)});
  }
  takeOfCells(now, ofCells, taken);
  takeOfPairs(now, ofPairs, taken);
  return taken;
}

Mesh cellMesh(const World& world, const CellPath& path) {
  if (!world.bodies) return {};
  const int number = cellNumber(world.cells, path);
  return number < 0 ? Mesh{} : takeSurface(*world.bodies, world.bodies->slots[number]);
}

std::vector<Point> cellVertices(const World& world, const CellPath& path) { return cellMesh(world, path).vertices; }

}  // namespace morula
