#pragma once
// A world's state as named columns on file: one per field of state_fields.h. checkpoint*.cpp write and read it, and
// simulation/restore.cpp takes it over.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/fields.h"
#include "contacts/contacts.h"
#include "state/state_fields.h"

namespace morula {

using Numbers = std::vector<std::uint64_t>;
using Columns = std::vector<double>;
using Texts = std::vector<std::string>;

/// The values that a member of type T has on file: whole numbers, unless specialised below.
template <class T>
struct OnFile {
  using Column = Numbers;
};
template <>
struct OnFile<double> {
  using Column = Columns;
};
template <>
struct OnFile<Vector> : OnFile<double> {};  // three in a row
template <>
struct OnFile<std::optional<double>> : OnFile<double> {};  // 0: absent
template <>
struct OnFile<CellPath> {
  using Column = Texts;
};
template <HasChoices E>
struct OnFile<E> : OnFile<CellPath> {};
template <class T>
using ColumnOf = typename OnFile<std::remove_const_t<T>>::Column;

inline std::string columnName(const char* table, const Field& field) { return std::string(table) + "." + field.name; }

/// Returns the counters [10] in the order of the file.
template <IsA<Contacts> T>
auto countersOf(T& contacts) {
  auto& [searches, pairs, distanceTests, binVisits, rootTests, boxTests, boxesRefitted, treesBuilt] =
      contacts.list.counters;
  return std::array{&contacts.rebuilds, &contacts.pairEvaluations,
                    &searches,          &pairs,
                    &distanceTests,     &binVisits,
                    &rootTests,         &boxTests,
                    &boxesRefitted,     &treesBuilt};
}

/// The part of contacts that a checkpoint keeps. The list is built anew from the positions of its last build, and is
/// then the same.
struct SavedContacts {
  // [cell]; radii follow growth at cell cycles only, so they do not follow from the rest scales.
  Columns radius;
  Columns snapshotRadius;  // in the last snapshot, which measures are taken from
  Columns reference;       // [cell][vertex][xyz]
  bool listIsValid = false;
  Numbers counters;  // countersOf
};

/// The state that was read from a checkpoint. `world` holds its state alone, without Contacts.
struct SavedState {
  World world;
  SavedContacts contacts;
};

inline void demand(bool holds, const std::string& what) {
  if (!holds) throw InputError("checkpoint: its parts contradict each other: " + what);
}

void writeState(FieldWriter& out, const World& world);

/// Reads a state with the same parts as `world`'s. `experiments`: whether the state has a part of that name. Throws
/// InputError for fields that are missing, or that cannot be of this world's scene.
SavedState readState(FieldReader& in, const World& world, bool experiments);

/// Throws InputError for a state that no run of this world's scene can have been in, and that is not safe to take over.
void checkSavedState(const SavedState& state, const World& world);

/// Reads and checks a whole checkpoint of this world's scene without its `added` last experiments. Throws InputError
/// unless it is whole, of this version and of this scene.
SavedState readCheckpoint(std::string_view checkpoint, const World& world, std::size_t added = 0);

/// Writes vectors of all cells' vertices, in the order of lineage paths.
void writeVectors(const Columns& values, const Bodies& b, Reals& array);

}  // namespace morula
