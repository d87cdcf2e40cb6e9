// A world's state as columns.
#include <cmath>
#include <map>
#include <variant>

#include "state/checkpoint_state.h"

namespace morula {
namespace {

Columns vectorsOf(const Bodies& b, const Reals& array) {
  Columns values;
  values.reserve(std::size_t(b.livingVertices) * 3);
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      const Vector u = b.read(array, slot, v);
      values.insert(values.end(), {u.x, u.y, u.z});
    }
  return values;
}

Columns valuesOf(const Bodies& b, const AlignedVector<double>& perSlot) {
  Columns values;
  for (int slot : b.slots) values.push_back(perSlot[slot]);
  return values;
}

/// Returns the influence radius [length] of each cell in the last snapshot.
Columns snapshotRadii(const Contacts& c, const Bodies& b) {
  Columns radii;
  for (int slot : b.slots) {
    const std::size_t first = b.at(slot, 0) / vertexStride * blockLanes + slot % blockLanes;
    radii.push_back(1 / std::sqrt(double(readRow(c.rows[first], b.parameters.precision).inverseRadiusSquared)));
  }
  return radii;
}

/// Writes part after part [visitState].
class StateWriter {
 public:
  StateWriter(FieldWriter& out, const World& world) : out_(out), world_(world) {}

  void operator()(const char* table, const Clock& clock) {
    visitFields(clock, [&]<class T>(const Field& field, const T& value) {
      out_.add(columnName(table, field), ColumnOf<T>{value});
    });
  }

  void operator()(const char* table, const Cells& cells) {
    for (StateId state : cells.state) describe(state);
    for (const LineageEntry& entry : world_.lineage.entries) describe(entry.state);
    out_.add("states", descriptions_);
    visitFields(cells, [&]<class Member>(const Field& field, const Member& member) {
      out_.add(columnName(table, field), column(member));
    });
  }

  template <class Record>
  void operator()(const char* table, const std::vector<Record>& rows) {
    std::vector<std::pair<std::string, std::variant<Numbers, Columns, Texts>>> columns;
    const Record none{};
    visitFields(none, [&]<class T>(const Field& field, const T&) {
      columns.emplace_back(columnName(table, field), ColumnOf<T>{});
    });
    for (const Record& row : rows) {
      auto next = columns.begin();
      visitFields(row,
                  [&]<class T>(const Field&, const T& value) { put(std::get<ColumnOf<T>>((next++)->second), value); });
    }
    for (const auto& named : columns)  // a lambda cannot capture a structured binding
      std::visit([&](const auto& values) { out_.add(named.first, values); }, named.second);
  }

  void operator()(const char* table, const Bodies& b) {
    Numbers levels;
    for (int slot : b.slots) levels.push_back(b.blocks[slot / blockLanes].meshLevel);
    out_.add("bodies.coarseness", levels);
    visitFields(b, [&]<class Member>(const Field& field, const Member& member) {
      if constexpr (std::same_as<Member, Reals>)
        out_.add(columnName(table, field), vectorsOf(b, member), b.parameters.precision);
      else out_.add(columnName(table, field), valuesOf(b, member));
    });
  }

  void operator()(const char*, const Contacts& c) {
    const Bodies& b = *world_.bodies;
    out_.add("contacts.radius", valuesOf(b, c.radius));
    out_.add("contacts.shown radius", snapshotRadii(c, b));
    out_.add("contacts.reference", vectorsOf(b, c.list.reference), b.parameters.precision);
    out_.add("contacts.list is valid", Numbers{c.listIsValid});
    Numbers counters;
    for (const std::uint64_t* counter : countersOf(c)) counters.push_back(*counter);
    out_.add("contacts.counters", counters);
  }

 private:
  /// Returns a state's place among the descriptions, which all columns of states refer to.
  std::uint64_t describe(StateId state) {
    const auto [at, isNew] = places_.try_emplace(state, descriptions_.size());
    if (isNew) descriptions_.push_back(world_.biology->describe(state));
    return at->second;
  }

  template <class T>
  ColumnOf<T> column(const std::vector<T>& member) {
    ColumnOf<T> values;
    for (const T& value : member) put(values, value);
    return values;
  }
  Numbers column(StateNumbers<const std::vector<StateId>> member) {
    Numbers values;
    for (const StateId& state : member.of) put(values, StateNumbers{state});
    return values;
  }

  void put(Columns& column, double value) { column.push_back(value); }
  void put(Columns& column, const Vector& u) { column.insert(column.end(), {u.x, u.y, u.z}); }
  void put(Columns& column, const std::optional<double>& value) { column.push_back(value.value_or(0)); }
  void put(Texts& column, const CellPath& path) { column.push_back(path.text()); }
  void put(Texts& column, HasChoices auto value) { column.push_back(nameOf(value)); }
  void put(Numbers& column, StateNumbers<const StateId> state) { column.push_back(describe(state.of)); }
  void put(Numbers& column, std::uint64_t value) { column.push_back(value); }
  void put(Numbers& column, Fate fate) { column.push_back(static_cast<std::uint64_t>(fate)); }

  FieldWriter& out_;
  const World& world_;
  std::map<StateId, std::uint64_t> places_;
  Texts descriptions_;
};

}  // namespace

void writeState(FieldWriter& out, const World& world) { visitState(world, StateWriter(out, world)); }

}  // namespace morula
