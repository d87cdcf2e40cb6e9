#include "explain/explain.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <variant>

#include "base/cell_path.h"
#include "golden/difference.h"
#include "golden/read_number.h"
#include "loop/simulate.h"
#include "simulation/simulation.h"
#include "state/state_fields.h"

namespace morula {
namespace {

/// The value of a field, for comparison. The vector is [vertex][xyz] of one cell.
using Value = std::variant<double, std::uint64_t, std::string, std::vector<double>>;

Value valueOf(const World&, double a) { return a; }
Value valueOf(const World&, std::uint64_t a) { return a; }
Value valueOf(const World&, std::uint32_t a) { return std::uint64_t{a}; }
Value valueOf(const World&, std::span<const double> a) { return std::vector<double>(a.begin(), a.end()); }
Value valueOf(const World&, HasChoices auto a) { return nameOf(a); }
Value valueOf(const World&, Fate a) { return name(a); }
Value valueOf(const World&, const CellPath& a) { return a.text(); }
Value valueOf(const World& world, StateNumbers<const StateId> a) { return world.biology->describe(a.of); }

/// Finds the first difference among the fields of one part of the state.
class Finder {
 public:
  std::optional<StateDifference> found;

  /// Sets the subject of the next comparisons. `path`: the cell, if any.
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
class Comparison : public SavedParts {
 public:
  using SavedParts::operator();
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

  void operator()(const char*, const std::vector<ExperimentRecord>& records) {
    if (actual_.experiments)
      compareTables(clock_, false, "experiments done", records, *actual_.experiments,
                    [](const ExperimentRecord& record) { return record.path; });
  }

  void operator()(const char*, const Bodies&) {
    const auto& path = expected_.cells.path;
    if (!actual_.bodies || path.size() != actual_.cells.path.size()) return;
    for (std::size_t i = 0; i < path.size() && !bodies_.found; ++i) {
      bodies_.about(false, path[i].text());
      compareRows(bodies_, valuesOfBody(expected_, i), valuesOfBody(actual_, i));
    }
  }

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

  /// `visitWith` visits the fields of the row.
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
  /// Puts accelerations before velocities, since a step makes velocities from accelerations.
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

  /// Compares tables row by row, then their numbers of rows.
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

  /// Compares which cells there are: the first by path that only one state has is the difference.
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

constexpr std::uint64_t toTheEnd = std::numeric_limits<std::uint64_t>::max() / 2;

/// The steps between which the hashes of two runs first differ.
struct Window {
  bool same = false;
  std::optional<std::uint64_t> lastEqual;
  std::uint64_t first = 0;                                   // the first step known to differ
  const StateHashes *expected = nullptr, *actual = nullptr;  // at step `first`; null if a run has no state there
};

Window partingOf(const HashTrace& e, const HashTrace& a) {
  Window w;
  const std::size_t both = std::min(e.links.size(), a.links.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (e.links[i].step == a.links[i].step && e.links[i].state.whole == a.links[i].state.whole) {
      w.lastEqual = e.links[i].step;
      continue;
    }
    w.first = std::min(e.links[i].step, a.links[i].step);
    w.expected = &e.links[i].state, w.actual = &a.links[i].state;
    return w;
  }
  w.same = e.links.size() == a.links.size() && e.lastStep == a.lastStep && e.failure == a.failure;
  w.first = std::min(e.lastStep, a.lastStep) + (e.failure == a.failure ? 1 : 0);  // one ended or failed there
  if (w.lastEqual && w.first <= *w.lastEqual) w.first = *w.lastEqual + 1;
  return w;
}

std::vector<std::string> cellsThatDiffer(const StateHashes& e, const StateHashes& a) {
  std::vector<std::string> cells;
  auto i = e.cells.begin(), j = a.cells.begin();
  while (i != e.cells.end() || j != a.cells.end()) {
    if (j == a.cells.end() || (i != e.cells.end() && i->path < j->path)) cells.push_back((i++)->path.text());
    else if (i == e.cells.end() || j->path < i->path) cells.push_back((j++)->path.text());
    else {
      if (i->hash != j->hash) cells.push_back(i->path.text());
      ++i, ++j;
    }
  }
  return cells;
}

std::string describe(const Explanation& x, const std::string& e, const std::string& a, const HashTrace& te,
                     const HashTrace& ta) {
  std::string text = nameOf(x.failureClass) + std::string(": ");
  text += x.step == 0u ? "different before the first step"
                       : "the same up to step " + std::to_string(x.lastEqual.value_or(0)) + ", different at step " +
                             std::to_string(*x.step);
  text += "\n  expected  " + e + "\n  actual    " + a;
  if (x.difference) text += "\n  first     " + x.difference->text;
  if (!x.cells.empty())
    text += "\n  cells     " + inWords(x.cells) + (x.cells.size() == 1 ? " differs" : " differ") + " there";
  for (const auto& [who, trace] : {std::pair{"expected", &te}, std::pair{"actual", &ta}})
    if (!trace->failure.empty())
      text += "\n  " + std::string(who) + " ended at step " + std::to_string(trace->lastStep) + ": " + trace->failure;
  return text + '\n';
}

}  // namespace

std::optional<StateDifference> findStateDifference(const World& expected, const World& actual) {
  Comparison comparison(expected, actual);
  visitState(expected, comparison);
  return comparison.first();
}

Explanation explain(RunSource& expected, RunSource& actual, std::uint64_t every) {
  Explanation x;
  HashTrace e = expected.hashTrace(0, toTheEnd, every), a = actual.hashTrace(0, toTheEnd, every);
  if (!e.links.empty()) x.expectedEnd = e.links.back().state.whole;
  Window window = partingOf(e, a);
  if (window.same) {
    x.lastEqual = e.lastStep;
    x.text = "the same bits at all " + std::to_string(e.links.size()) + " states looked at, to step " +
             std::to_string(e.lastStep) + '\n';
    return x;
  }
  if (const std::uint64_t from = window.lastEqual.value_or(0); window.first > from + 1) {
    HashTrace finerE = expected.hashTrace(from, window.first, 1), finerA = actual.hashTrace(from, window.first, 1);
    const auto stepByStep = [from](const HashTrace& t) { return t.links.size() > 1 && t.links[1].step == from + 1; };
    if (stepByStep(finerE) && stepByStep(finerA)) {
      const Window finer = partingOf(finerE, finerA);
      if (finer.same) window = {false, window.first, window.first + 1};  // one run ends there, the other goes on
      else e = std::move(finerE), a = std::move(finerA), window = partingOf(e, a);
    }
  }
  x.lastEqual = window.lastEqual;
  x.step = window.first;
  if (window.expected && window.actual) x.cells = cellsThatDiffer(*window.expected, *window.actual);
  const auto worldE = expected.stateAt(window.first), worldA = actual.stateAt(window.first);
  if (worldE && worldA) x.difference = findStateDifference(*worldE, *worldA);
  x.cell = x.difference ? x.difference->cell : x.cells.empty() ? std::nullopt : std::optional(x.cells.front());
  x.failureClass = window.first == 0                       ? FailureClass::setup
                   : x.difference && x.difference->lineage ? FailureClass::lineage
                                                           : FailureClass::computation;
  x.text = describe(x, expected.name, actual.name, e, a);
  for (const RunSource* w : {&expected, &actual})
    if (!w->noState.empty()) x.text += "  no vertex and values: " + w->name + ": " + w->noState + '\n';
  return x;
}

Explanation explainTwice(RunSource& first, RunSource& second, std::uint64_t every) {
  Explanation x = explain(first, second, every);
  if (x.failureClass == FailureClass::none) return x;
  x.failureClass = FailureClass::nondeterminism;
  x.text = "NONDETERMINISM: two runs of this program differ, so other differences have no meaning\n" + x.text;
  return x;
}

Explanation explainTwice(const Scenario& scenario, const Execution& how, std::uint64_t every) {
  OwnRun first = scenarioRun(scenario, how), second = scenarioRun(scenario, otherExecution(how));
  return explainTwice(first, second, every);
}

}  // namespace morula
