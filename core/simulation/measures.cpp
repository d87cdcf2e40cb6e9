// How measures are taken. Their rows: measures_world.cpp, measures_cell.cpp, measures_pair.cpp.
#include "simulation/measures.h"

#include <algorithm>

#include "base/error.h"
#include "physics/bodies.h"

namespace morula {

namespace {

/// True if there is what a measure needs.
bool has(const Observation& now, Needs needs) {
  const World& world = now.world;
  switch (needs) {
    case Needs::nothing:
      return true;
    case Needs::shell:
      return world.bodies && world.bodies->parameters.shell;
    case Needs::bodies:
    case Needs::contact:  // without contact no cells touch: 0, not unknown
      return world.bodies.has_value();
    case Needs::referenceContacts:
      return world.bodies && now.reference && !now.reference->contacts.empty();
    case Needs::referencePositions:
      return world.bodies && now.reference && !now.reference->positions.empty();
  }
  MORULA_CHECK(false, "a need that is not known");
}

template <class Of>
void take(const Observation& now, const Of& of, Measured<Of>& into) {
  const auto rows = sampledMeasures<Of>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (has(now, rows[i].needs)) into.values[i] = rows[i].get(of);
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

/// The row on demand that goes by this name; null if none does.
template <class Of>
const Measure<Of>* rowOnDemand(std::string_view name) {
  for (const Measure<Of>& row : measures<Of>())
    if (row.taken == Taken::onDemand && row.name == name) return &row;
  return nullptr;
}

template <class Of>
void describeRows(Scope scope, std::vector<MeasureOnDemand>& all) {
  for (const Measure<Of>& row : measures<Of>())
    if (row.taken == Taken::onDemand) all.push_back({scope, row.name, row.needs});
}

/// Of one thing: nothing if there is nothing to measure.
template <class Of>
void takeOne(const Observation& now, const Measure<Of>& row, Scope scope, const CellPath& a,
             const CellPath& b, const Of& of, std::vector<TakenMeasure>& taken) {
  if (!has(now, row.needs)) return;
  if (const std::optional<double> value = row.get(of)) taken.push_back({scope, row.name, a, b, *value});
}

void takeOfCells(const Observation& now, const std::vector<const CellMeasure*>& rows,
                 std::vector<TakenMeasure>& taken) {
  if (rows.empty()) return;
  for (int i = 0; i < static_cast<int>(now.world.cells.path.size()); ++i) {
    const ObservedCell cell(now, i);  // so that only one shape is in memory at a time
    for (const CellMeasure* row : rows)
      takeOne<CellContext>(now, *row, Scope::cell, cell.path, {}, cell, taken);
  }
}

void takeOfPairs(const Observation& now, const std::vector<const PairMeasure*>& rows,
                 std::vector<TakenMeasure>& taken) {
  if (rows.empty()) return;
  const std::vector<ContactArea>& contacts = now.contacts();
  const std::span<const double> durations = now.contactDurations;
  MORULA_CHECK(durations.empty() || durations.size() == contacts.size(), "one duration for each contact");
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b, area] = contacts[i];
    const Touch touch{now.cell(a), now.cell(b), area,
                      durations.empty() ? std::nullopt : std::optional(durations[i])};
    for (const PairMeasure* row : rows)
      takeOne(now, *row, Scope::pair, touch.a.path, touch.b.path, touch, taken);
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
  std::vector<const CellMeasure*> ofCells;
  std::vector<const PairMeasure*> ofPairs;
  for (const std::string& name : names) {
    if (const auto* row = rowOnDemand<Observation>(name))
      takeOne(now, *row, Scope::world, {}, {}, now, taken);
    else if (const auto* ofCell = rowOnDemand<CellContext>(name)) ofCells.push_back(ofCell);
    else if (const auto* ofPair = rowOnDemand<Touch>(name)) ofPairs.push_back(ofPair);
    else MORULA_CHECK(false, "a measure on demand that no row names");
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

std::vector<Point> cellVertices(const World& world, const CellPath& path) {
  return cellMesh(world, path).vertices;
}

}  // namespace morula
