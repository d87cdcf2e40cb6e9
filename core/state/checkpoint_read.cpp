// Reads a state from columns.
#include <algorithm>
#include <limits>
#include <variant>

#include "physics/sag.h"
#include "state/checkpoint_state.h"

namespace morula {
namespace {

/// How many numbers on file make one value.
template <class T>
constexpr std::size_t widthOf = 1;
template <>
constexpr std::size_t widthOf<Vector> = 3;

void demandLength(std::size_t actual, std::size_t length, const char* table) {
  demand(actual == length, std::string(table) + " have columns of different lengths");
}

void readFrom(FieldReader& in, const std::string& name, Numbers& column) { column = in.numbers(name); }
void readFrom(FieldReader& in, const std::string& name, Columns& column) { column = in.reals(name); }
void readFrom(FieldReader& in, const std::string& name, Texts& column) { column = in.texts(name); }
template <class Column>
Column readColumn(FieldReader& in, const std::string& name) {
  Column column;
  readFrom(in, name, column);
  return column;
}

template <class Column>
auto readSingle(FieldReader& in, const std::string& name) {
  const Column column = readColumn<Column>(in, name);
  if (column.size() != 1) throw InputError("checkpoint: the field '" + name + "' holds no single value");
  return column[0];
}

/// Returns how many numbers positions, velocities and the like have. Demands that the meshes are the scene's.
std::size_t countCoordinates(const Numbers& levels, const Bodies& bodies) {
  std::size_t vertices = 0;
  for (std::uint64_t level : levels) {
    demand(level <= bodies.coarser.size(), "a cell has a mesh that the scene has not");
    vertices += bodies.meshAt(static_cast<int>(level)).vertexCount();
  }
  return 3 * vertices;
}

/// Makes cells with these meshes, with no numbers yet.
void makeRoom(Bodies& b, const Numbers& levels) {
  std::vector<Body> cells;
  for (std::uint64_t level : levels) {
    Body cell;
    cell.meshLevel = static_cast<int>(level);
    cell.position.resize(b.meshAt(cell.meshLevel).vertexCount());
    cell.velocity.resize(cell.position.size());
    cells.push_back(std::move(cell));
  }
  setBodies(b, cells);
}

/// Reads part after part [visitState], each into its place in a world.
class StateReader {
 public:
  StateReader(FieldReader& in, BiologicalUnit& biology, SavedState& read) : in_(in), biology_(biology), read_(read) {}

  void operator()(const char* table, Clock& clock) {
    visitFields(clock, [&]<class T>(const Field& field, T& value) {
      value = readSingle<ColumnOf<T>>(in_, columnName(table, field));
    });
  }

  void operator()(const char* table, Cells& cells) {
    for (const std::string& text : in_.texts("states")) states_.push_back(biology_.stateOf(text));
    visitFields(cells, [&](const Field& field, auto&& member) {
      const std::size_t rows = read(columnName(table, field), member);
      demandLength(rows, cells.path.size(), table);  // of the paths, which come first
    });
  }

  template <class Record>
  void operator()(const char* table, std::vector<Record>& rows) {
    std::vector<std::variant<Numbers, Columns, Texts>> columns;
    std::optional<std::size_t> length;
    Record none{};
    visitFields(none, [&]<class T>(const Field& field, const T&) {
      auto column = readColumn<ColumnOf<T>>(in_, columnName(table, field));
      if (!length) length = column.size();
      demandLength(column.size(), *length * widthOf<T>, table);
      columns.emplace_back(std::move(column));
    });
    rows.assign(*length, {});
    for (std::size_t row = 0; row < rows.size(); ++row) {
      auto next = columns.begin();
      visitFields(rows[row], [&]<class T>(const Field&, T&& value) {
        using Column = ColumnOf<std::remove_reference_t<T>>;
        take(std::get<Column>(*next++), row, value);
      });
    }
  }

  void operator()(const char* table, Bodies& b) {
    const Numbers levels = in_.numbers("bodies.coarseness");
    const std::size_t cells = read_.world.cells.path.size(), coordinates = countCoordinates(levels, b);
    demandLength(levels.size(), cells, table);
    std::vector<Columns> columns;
    visitFields(b, [&]<class Member>(const Field& field, const Member&) {
      columns.push_back(in_.reals(columnName(table, field)));
      demandLength(columns.back().size(), std::same_as<Member, Reals> ? coordinates : cells, table);
    });
    makeRoom(b, levels);
    auto next = columns.begin();
    visitFields(b, [&]<class Member>(const Field&, Member& member) {
      const Columns& values = *next++;
      if constexpr (std::same_as<Member, Reals>) writeVectors(values, b, member);
      else
        for (std::size_t cell = 0; cell < cells; ++cell) member[b.slots[cell]] = values[cell];
    });
    setSags(b);
  }

  void operator()(const char* table, Contacts& contacts) {
    const Bodies& b = *read_.world.bodies;
    SavedContacts& c = read_.contacts;
    c.radius = in_.reals("contacts.radius");
    c.snapshotRadius = in_.reals("contacts.shown radius");
    c.reference = in_.reals("contacts.reference");
    c.listIsValid = readSingle<Numbers>(in_, "contacts.list is valid") != 0;
    c.counters = in_.numbers("contacts.counters");
    for (const Columns* column : {&c.radius, &c.snapshotRadius}) demandLength(column->size(), b.count, table);
    demandLength(c.reference.size(), std::size_t(b.livingVertices) * 3, table);
    demandLength(c.counters.size(), countersOf(contacts).size(), table);
  }

 private:
  template <class T>
  std::size_t read(const std::string& name, std::vector<T>& member) {
    const auto column = readColumn<ColumnOf<T>>(in_, name);
    member.resize(column.size());
    for (std::size_t i = 0; i < column.size(); ++i) take(column, i, member[i]);
    return column.size();
  }
  std::size_t read(const std::string& name, StateNumbers<std::vector<StateId>> member) {
    const Numbers places = in_.numbers(name);
    member.of.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) take(places, i, StateNumbers{member.of[i]});
    return places.size();
  }

  void take(const Columns& column, std::size_t row, double& value) { value = column[row]; }
  void take(const Columns& column, std::size_t row, Vector& u) {
    u = {column[3 * row], column[3 * row + 1], column[3 * row + 2]};
  }
  void take(const Columns& column, std::size_t row, std::optional<double>& value) {
    if (column[row] > 0) value = column[row];
  }
  void take(const Texts& column, std::size_t row, CellPath& path) { path = CellPath::parse(column[row]); }
  template <HasChoices E>
  void take(const Texts& column, std::size_t row, E& value) {
    const auto known = valueNamed<E>(column[row]);
    demand(known.has_value(), "'" + column[row] + "' is none of " + namesOf<E>());
    value = *known;
  }
  void take(const Numbers& column, std::size_t row, StateNumbers<StateId> state) {
    demand(column[row] < states_.size(), "a cell has no state");
    state.of = states_[column[row]];
  }
  void take(const Numbers& column, std::size_t row, std::uint64_t& value) { value = column[row]; }
  void take(const Numbers& column, std::size_t row, std::uint32_t& value) {
    demand(column[row] <= std::numeric_limits<std::uint32_t>::max(), "a cell's place in the lineage");
    value = static_cast<std::uint32_t>(column[row]);
  }
  void take(const Numbers& column, std::size_t row, Fate& fate) {
    demand(column[row] <= static_cast<std::uint64_t>(Fate::died), "an unknown fate");
    fate = static_cast<Fate>(column[row]);
  }

  FieldReader& in_;
  BiologicalUnit& biology_;
  SavedState& read_;
  std::vector<StateId> states_;  // [place among the descriptions]
};

}  // namespace

void writeVectors(const Columns& values, const Bodies& b, Reals& array) {
  std::size_t i = 0;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v, i += 3)
      b.write(array, slot, v, {values[i], values[i + 1], values[i + 2]});
}

SavedState readState(FieldReader& in, const World& world, bool experiments) {
  SavedState read;
  if (world.bodies) read.world.bodies = *world.bodies;
  if (world.contacts) read.world.contacts = Contacts();
  if (world.connections) read.world.connections.emplace();
  if (world.polarities) read.world.polarities.emplace();
  if (world.birthSizes) read.world.birthSizes.emplace();
  if (world.settlings) read.world.settlings.emplace();
  if (experiments) read.world.experiments.emplace();
  visitState(read.world, StateReader(in, *world.biology, read));
  in.end();
  return read;
}

}  // namespace morula
