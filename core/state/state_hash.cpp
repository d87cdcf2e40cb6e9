// Hashes field by named field, never over raw memory: where a cell lies in memory must not matter.

#include "state/state_hash.h"

#include <map>
#include <string>
#include <type_traits>

#include "state/check_numbers.h"
#include "state/state_fields.h"

namespace morula {
namespace {

/// The texts of states, looked up once each: a large lineage has few states.
class StateTexts {
 public:
  explicit StateTexts(const BiologicalUnit& biology) : biology_(biology) {}
  const std::string& operator()(StateId state) {
    const auto [text, isNew] = texts_.try_emplace(state);
    if (isNew) text->second = biology_.describe(state);
    return text->second;
  }

 private:
  const BiologicalUnit& biology_;
  std::map<StateId, std::string> texts_;
};

void add(Hasher& h, StateTexts&, const CellPath& p) { h.add(p.high()).add(p.low()).add(p.depth()); }
void add(Hasher& h, StateTexts&, std::uint32_t number) { h.add(std::uint64_t{number}); }
void add(Hasher& h, StateTexts&, Fate fate) { h.add(static_cast<int>(fate)); }
void add(Hasher& h, StateTexts&, HasChoices auto value) { h.add(nameOf(value)); }
void add(Hasher& h, StateTexts& texts, StateNumbers<const StateId> state) { h.add(texts(state.of)); }
template <class T>
requires(!HasChoices<T>) void add(Hasher& h, StateTexts&, const T& value) { h.add(value); }

/// Hashes the parts of a state. A new part does not compile until its treatment is decided here or in SavedParts.
struct PartHasher : SavedParts {
  const World& world;
  StateHashes parts{};
  StateTexts texts{*world.biology};

  explicit PartHasher(const World& of) : world(of) {}

  using SavedParts::operator();

  auto fieldsInto(Hasher& h) {
    return [this, &h](const Field& field, const auto& value) {
      if (field.use == Use::result) add(h, texts, value);
    };
  }

  void operator()(const char*, const Clock& clock) {
    Hasher h;
    visitFields(clock, fieldsInto(h));
    parts.clock = h.digest();
  }
  void operator()(const char*, const Cells& cells) {
    parts.cells.reserve(cells.path.size());
    for (std::size_t i = 0; i < cells.path.size(); ++i) {
      Hasher h;
      visitCell(cells, i, fieldsInto(h));
      if (world.bodies)
        visitBody(*world.bodies, world.bodies->slots[i], [&](const Field& field, const auto& value) {
          if (field.use != Use::result) return;
          if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
            checkNumbers(world, i, field.name, {&value, 1});
          else checkNumbers(world, i, field.name, value);
          h.field(field.name).add(value);
        });
      parts.cells.push_back({cells.path[i], h.digest()});
    }
  }
  void operator()(const char* name, const std::vector<LineageEntry>& entries) {
    parts.lineage = hashRows(name, entries);
  }
  void operator()(const char* name, const std::vector<ConnectionRecord>& connections) {
    parts.connections = hashRows(name, connections);
  }
  /// Adds the deeds that were done to the part of the clock, which comes before: they decide how the scene goes on.
  void operator()(const char* name, const std::vector<ExperimentRecord>& records) {
    parts.clock = Hasher().add(parts.clock).add(hashRows(name, records)).digest();
  }
  void operator()(const char*, const Bodies&) {}  // with their cells

  template <class Record>
  Hash hashRows(const char* name, const std::vector<Record>& rows) {
    Hasher h;
    h.field(name).add(std::uint64_t{rows.size()});
    for (const Record& row : rows) visitFields(row, fieldsInto(h));
    return h.digest();
  }
};

}  // namespace

Hash hashWhole(const StateHashes& parts) {
  Hasher h;
  h.field("clock").add(parts.clock).field("cells").add(std::uint64_t{parts.cells.size()});
  for (const CellHash& cell : parts.cells) h.add(cell.hash);
  return h.field("connections").add(parts.connections).field("lineage").add(parts.lineage).digest();
}

StateHashes hashState(const World& world) {
  PartHasher hasher(world);
  visitState(world, hasher);
  hasher.parts.whole = hashWhole(hasher.parts);
  return std::move(hasher.parts);
}

Hash hashLink(const std::optional<Hash>& before, std::uint64_t step, const Hash& state) {
  return Hasher().add(before.value_or(Hash{})).add(step).add(state).digest();
}

ChainLink nextLink(const std::optional<Hash>& before, const World& world) {
  ChainLink link{world.clock.step, {}, hashState(world)};
  link.hash = hashLink(before, link.step, link.state.whole);
  return link;
}

}  // namespace morula
