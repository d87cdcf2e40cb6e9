#include "explain/state_difference.h"

#include <algorithm>
#include <array>
#include <bit>
#include <variant>

#include "base/cell_path.h"
#include "golden/difference.h"
#include "golden/number_text.h"
#include "simulation/state_fields.h"

namespace morula {
namespace {

/// What a field holds, for comparing. The last: [vertex][xyz] of one cell.
using Value = std::variant<double, std::uint64_t, std::string, std::vector<double>>;

Value valueOf(const World&, double a) { return a; }
Value valueOf(const World&, std::uint64_t a) { return a; }
Value valueOf(const World&, std::uint32_t a) { return std::uint64_t{a}; }
Value valueOf(const World&, std::span<const double> a) { return std::vector<double>(a.begin(), a.end()); }
Value valueOf(const World&, const char* a) { return a; }
Value valueOf(const World&, Fate a) { return name(a); }
Value valueOf(const World&, const CellPath& a) { return a.text(); }
Value valueOf(const World& world, StateNumbers<const StateId> a) { return world.biology->describe(a.of); }

/// What is found first among the fields of one part of the state.
class Finder {
 public:
  std::optional<StateDifference> found;

  /// What is compared from here on. `path`: whose it is, if a cell's.
  void about(bool lineage, std::optional<std::string> path) { lineage_ = lineage, path_ = std::move(path); }

  void compare(const char* field, const Value& e, const Value& a) {
    std::visit([&](const auto& value) { differ(field, value, std::get<std::decay_t<decltype(value)>>(a)); }, e);
  }

 private:
  void differ(const char* field, double e, double a) {
    if (std::bit_cast<std::uint64_t>(e) != std::bit_cast<std::uint64_t>(a))
      note(field, exactText(e), exactText(a), compareInWords(e, a));
  }
  void differ(const char* field, std::uint64_t e, std::uint64_t a) {
    differ(field, std::to_string(e), std::to_string(a));
  }
  void differ(const char* field, const std::string& e, const std::string& a) {
    if (e != a) note(field, e, a, "expected '" + e + "', actual '" + a + "'");
  }
  void differ(const char* field, const std::vector<double>& e, const std::vector<double>& a) {
    for (std::size_t k = 0; k < std::min(e.size(), a.size()) && !found; ++k) {
      vertex_ = static_cast<int>(k / 3), component_ = "xyz"[k % 3];
      differ(field, e[k], a[k]);
    }
    vertex_.reset(), component_.clear();
  }

  void note(const char* field, const std::string& e, const std::string& a, const std::string& words) {
    if (found) return;
    std::string what = path_ ? cellName(*path_) + ": " : "";
    what += field;
    if (vertex_) what += " of vertex " + std::to_string(*vertex_) + ", " + component_;
    found = {lineage_, path_, field, vertex_, component_, e, a, what + ": " + words};
  }

  bool lineage_ = false;
  std::optional<std::string> path_;
  std::optional<int> vertex_;
  std::string component_;
};

/// Compares each part of the expected state [visitState] with the actual one's.
class Comparison {
 public:
  Comparison(const World& expected, const World& actual) : expected_(expected), actual_(actual) {}

  void operator()(const char*, const Clock& clock) { compareRecords(clock_, clock, actual_.clock); }

  void operator()(const char*, const Cells& cells) {
    comparePopulation(cells.path, actual_.cells.path);
    const std::size_t count = std::min(cells.path.size(), actual_.cells.path.size());
    for (std::size_t i = 0; i < count && !cells_.found; ++i) {
      cells_.about(true, cells.path[i].text());
      compareRows(cells_, valuesOfCell(expected_, i), valuesOfCell(actual_, i));
    }
  }

  void operator()(const char*, const std::vector<LineageEntry>& entries) {
    compareTables(lineage_, true, "cells ever", entries, actual_.lineage.entries,
                  [](const LineageEntry& entry) { return entry.path; });
  }
  void operator()(const char*, const std::vector<ConnectionRecord>& connections) {
    if (actual_.connections)
      compareTables(connections_, false, "connections ever", connections, actual_.connections->history,
                    [](const ConnectionRecord& connection) { return connection.a; });
  }

  void operator()(const char*, const Bodies&) {
    const auto& path = expected_.cells.path;
    if (!actual_.bodies || path.size() != actual_.cells.path.size()) return;
    for (std::size_t i = 0; i < path.size() && !bodies_.found; ++i) {
      bodies_.about(false, path[i].text());
      compareRows(bodies_, valuesOfBody(expected_, i), valuesOfBody(actual_, i));
    }
  }

  // They tell of the way, or follow from positions.
  void operator()(const char*, const std::vector<TimeStepChange>&) {}
  void operator()(const char*, const std::vector<DivisionRecord>&) {}
  void operator()(const char*, const std::vector<PolarityRecord>&) {}
  void operator()(const char*, const std::vector<BirthSize>&) {}
  void operator()(const char*, const std::vector<SettlingRecord>&) {}
  void operator()(const char*, const Contacts&) {}

  std::optional<StateDifference> first() const {
    for (const Finder* part : {&cells_, &lineage_, &connections_, &clock_, &bodies_})
      if (part->found) return part->found;
    return {};
  }

 private:
  using Row = std::vector<std::pair<const char*, Value>>;  // label and value

  static void compareRows(Finder& f, const Row& e, const Row& a) {
    for (std::size_t k = 0; k < e.size(); ++k) f.compare(e[k].first, e[k].second, a[k].second);
  }

  /// `visitWith` visits what is compared.
  static Row rowOf(const World& world, const auto& visitWith) {
    Row row;
    visitWith([&](const Field& field, const auto& value) {
      if (field.use != Use::saved) row.emplace_back(field.label, valueOf(world, value));
    });
    return row;
  }

  static Row valuesOf(const World& world, const auto& record) {
    return rowOf(world, [&](auto&& visit) { visitFields(record, visit); });
  }
  static Row valuesOfCell(const World& world, std::size_t cell) {
    return rowOf(world, [&](auto&& visit) { visitCell(world.cells, cell, visit); });
  }
  /// Accelerations before velocities, which a step makes of them.
  static Row valuesOfBody(const World& world, std::size_t cell) {
    const int slot = world.bodies->slots[cell];
    Row row = rowOf(world, [&](auto&& visit) { visitBody(*world.bodies, slot, visit); });
    row.emplace(row.begin(), "vertices", static_cast<std::uint64_t>(world.bodies->vertexCount(slot)));
    std::stable_partition(row.begin(), row.end(),
                          [](const auto& a) { return std::string_view(a.first) != "velocity"; });
    return row;
  }

  template <class Record>
  void compareRecords(Finder& f, const Record& e, const Record& a) const {
    compareRows(f, valuesOf(expected_, e), valuesOf(actual_, a));
  }

  /// Row by row, then their number.
  template <class Record, class CellOf>
  void compareTables(Finder& f, bool lineage, const char* number, const std::vector<Record>& e,
                     const std::vector<Record>& a, const CellOf& cellOf) const {
    for (std::size_t i = 0; i < std::min(e.size(), a.size()) && !f.found; ++i) {
      f.about(lineage, cellOf(e[i]).text());
      compareRecords(f, e[i], a[i]);
    }
    f.about(lineage, std::nullopt);
    f.compare(number, std::uint64_t{e.size()}, std::uint64_t{a.size()});
  }

  /// Cells that only one of the two has: the first by path tells.
  void comparePopulation(const std::vector<CellPath>& e, const std::vector<CellPath>& a) {
    const auto [ie, ia] = std::mismatch(e.begin(), e.end(), a.begin(), a.end());
    if (ie == e.end() && ia == a.end()) return;
    const bool onlyExpected = ia == a.end() || (ie != e.end() && *ie < *ia);
    cells_.about(true, (onlyExpected ? *ie : *ia).text());
    cells_.compare("life", onlyExpected ? "alive" : "not there", onlyExpected ? "not there" : "alive");
  }

  const World &expected_, &actual_;
  Finder cells_, lineage_, connections_, clock_, bodies_;
};

}  // namespace

std::optional<StateDifference> findStateDifference(const World& expected, const World& actual) {
  Comparison comparison(expected, actual);
  visitState(expected, comparison);
  return comparison.first();
}

}  // namespace morula
