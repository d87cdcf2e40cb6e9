#pragma once
// The lines of a golden file's body: `kind field…`, each a struct. Kind and first field (the key) name the item; the
// other fields must agree. A struct's members determine reading, writing, comparison and heading. A new kind is one
// struct, the list of its members and its place in GoldenItem.
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "base/cell_path.h"
#include "base/hash.h"
#include "base/members.h"
#include "biology/lineage.h"
#include "golden/old_error.h"

namespace morula {

/// The rest of a line, including blanks; may be empty.
struct RestOfLine {
  std::string text;
  friend bool operator==(const RestOfLine&, const RestOfLine&) = default;
};

/// The name of a value: "final/AB/volume", "0.5/organism/cells"
struct ValueName {
  std::optional<double> time;    // [time] of the sample; absent: at the end
  std::optional<CellPath> cell;  // absent: the organism
  std::string measure;           // [observation/measures.h]
  friend auto operator<=>(const ValueName&, const ValueName&) = default;
};

// `kind`: the first word of the line; the fields follow in the order of the members. `check`: the check that compares
// the item. `line`: its line in the file, 0 if observed, the last member of all.

struct GoldenCount {
  static constexpr const char *kind = "count", *check = "counts";
  std::string name;
  std::uint64_t count = 0;
  int line = 0;
};
MORULA_MEMBERS(GoldenCount, name, count, line)

struct GoldenCell {
  static constexpr const char *kind = "cell", *check = "lineage";
  CellPath path;
  double born = 0;  // [time]
  std::uint64_t bornStep = 0;
  std::optional<double> ended;  // [time] absent: it lives
  std::optional<std::uint64_t> endedStep;
  Fate fate = Fate::alive;
  RestOfLine state;  // substances
  int line = 0;
};
MORULA_MEMBERS(GoldenCell, path, born, bornStep, ended, endedStep, fate, state, line)

/// A generation in place of its cells, for large lineages.
struct GoldenGeneration {
  static constexpr const char *kind = "generation", *check = "lineage";
  std::uint64_t number = 0, cells = 0;
  Hash hash;
  int line = 0;
};
MORULA_MEMBERS(GoldenGeneration, number, cells, hash, line)

struct GoldenTimeStep {
  static constexpr const char *kind = "time_step", *check = "time_steps";
  std::uint64_t step = 0;
  double time = 0, timeStep = 0;  // [time]
  int line = 0;
};
MORULA_MEMBERS(GoldenTimeStep, step, time, timeStep, line)

struct GoldenBits {
  static constexpr const char *kind = "bits", *check = "bits";
  std::string domain;  // "solver"
  Hash hash;           // hash of the last state
  int line = 0;
};
MORULA_MEMBERS(GoldenBits, domain, hash, line)

struct GoldenLink {
  static constexpr const char *kind = "step_hash", *check = "step_hashes";
  std::uint64_t step = 0;
  Hash hash;
  RestOfLine cells;  // the last four digits of each living cell's hash, by path; empty for too many cells
  int line = 0;
};
MORULA_MEMBERS(GoldenLink, step, hash, cells, line)

struct GoldenImage {
  static constexpr const char *kind = "image", *check = "images", *undrawn = "none";
  std::string name;      // "organism"
  std::string renderer;  // one word, or `undrawn`; only pictures of one renderer are equal bit for bit
  Hash hash;             // hash of the pixels
  int line = 0;
};
MORULA_MEMBERS(GoldenImage, name, renderer, hash, line)

/// A counter of the cost of a run.
struct GoldenCost {
  static constexpr const char *kind = "cost", *check = "costs";
  std::string name;
  std::uint64_t count = 0;
  int line = 0;
};
MORULA_MEMBERS(GoldenCost, name, count, line)

struct GoldenValue {
  static constexpr const char *kind = "value", *check = "values";
  ValueName name;
  std::uint64_t step = 0;
  std::optional<double> value;  // absent: not measured; format 1 has 0 in its place
  int line = 0;
};
MORULA_MEMBERS(GoldenValue, name, step, value, line)

/// One column of a recorded table over all rows: "contact/area". A difference thus names the column, and a measure that
/// joins a table changes no other line.
struct GoldenColumn {
  static constexpr const char *kind = "column", *check = "tables";
  std::string name;
  std::uint64_t rows = 0;
  Hash hash;  // hash over each value and its row's key, in any order of the rows [store/recorded_tables.h]
  int line = 0;
};
MORULA_MEMBERS(GoldenColumn, name, rows, hash, line)

/// One row of a small recorded table: "contact/0.25/A/B".
struct GoldenRow {
  static constexpr const char *kind = "row", *check = "tables";
  std::string name;  // the table and the row's key
  std::uint64_t step = 0;
  RestOfLine values;  // "area=0.5 contact_duration=-", without blanks in a value; - is NULL
  int line = 0;
};
MORULA_MEMBERS(GoldenRow, name, step, values, line)

/// The error of the scenario's settings in one quantity, as `morula accuracy` has measured it; it is stated, and compared
/// with no run. Errors at rest are medians over quiet times, errors at worst bounds of the largest.
struct GoldenError {
  static constexpr const char *kind = "error", *check = "stated";
  std::string quantity;             // [accuracy/state_error.h]
  std::optional<double> rest;       // of time step and single precision, at rest; absent: no time is quiet
  double worst = 0, until = 0;      // at worst; last comparison [time]
  std::optional<double> meshRest;   // of the mesh, at rest; absent: not known, or no time is quiet
  std::optional<double> meshWorst;  // of the mesh, at worst; 0 for spheres; absent: not known
  std::optional<double> meshUntil;  // [time]
  int line = 0;
};
MORULA_MEMBERS(GoldenError, quantity, rest, worst, until, meshRest, meshWorst, meshUntil, line)

/// The reason why no error of the `time` step or of the `mesh` is stated, or none beyond a time.
struct GoldenUnstated {
  static constexpr const char *kind = "unstated", *check = "stated";
  std::string of;
  RestOfLine why;
  int line = 0;
};
MORULA_MEMBERS(GoldenUnstated, of, why, line)

/// An item of any kind, in the order of the file; stated kinds come first.
using GoldenItem =
    std::variant<OldGoldenError, GoldenError, GoldenUnstated, GoldenCount, GoldenCell, GoldenGeneration, GoldenTimeStep,
                 GoldenBits, GoldenLink, GoldenImage, GoldenCost, GoldenValue, GoldenColumn, GoldenRow>;

// Each goldenText gives one text per value, so that equal texts mean equal bits and vice versa.
std::string goldenText(std::uint64_t value);
std::string goldenText(double value);
std::string goldenText(const Hash& value);
std::string goldenText(const CellPath& value);
std::string goldenText(const ValueName& value);
inline std::string goldenText(Fate value) { return name(value); }
inline std::string goldenText(const std::string& value) { return value; }
inline std::string goldenText(const RestOfLine& value) { return value.text; }
template <class Value>
std::string goldenText(const std::optional<Value>& value) {
  return value ? goldenText(*value) : "-";
}

// Returns true for the same bits: −0 and 0 differ.
template <class Value>
bool agree(const Value& a, const Value& b) {
  return a == b;
}
inline bool agree(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }
inline bool agree(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || agree(*a, *b));
}

/// Splits off and returns the text before the next space; `rest` keeps the text after the space.
std::string_view takeWord(std::string_view& rest);

/// Returns the names of all members but `line` as golden files have them: "path born born_step".
std::string fieldNames(std::string_view members);

/// Calls visit(name, value…) for each field of one or several items of one kind.
template <class Visit, class Item, class... Others>
void visitGoldenFields(const Visit& visit, Item& item, Others&... others) {
  static const std::string all = fieldNames(memberNames(static_cast<const std::remove_const_t<Item>*>(nullptr)));
  std::string_view names = all;
  const auto visitField = [&]<std::size_t number>(std::integral_constant<std::size_t, number>) {
    visit(std::string(takeWord(names)), std::get<number>(members(item)), std::get<number>(members(others))...);
  };
  [&]<std::size_t... number>(std::index_sequence<number...>) {
    (visitField(std::integral_constant<std::size_t, number>{}), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(members(item))> - 1>{});  // without `line`
}

std::string kindOf(const GoldenItem& item);
std::string keyOf(const GoldenItem& item);
/// Returns kind and key: no two items of a file have the same.
inline std::string idOf(const GoldenItem& item) { return kindOf(item) + ' ' + keyOf(item); }
/// Returns the name of the check that compares the item.
inline std::string checkOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return i.check; }, item);
}
/// Returns true if all fields are the same, whatever their lines.
bool agree(const GoldenItem& a, const GoldenItem& b);

std::string write(const GoldenItem& item);
/// Returns "# cell path born born_step …", so that the file can be read without its description.
std::string headingOf(const GoldenItem& item);
/// Reads one line. Throws InputError that begins with `place` ("file:line").
GoldenItem readItem(std::string_view line, const std::string& place);

/// Returns the step at which the item happened, if the item has one.
std::optional<std::uint64_t> stepOf(const GoldenItem& item);
/// Returns the path of the item's cell, if the item has one; "" is the egg.
std::optional<std::string> cellOf(const GoldenItem& item);

}  // namespace morula
