#pragma once
// The lines of a golden file's body: `kind field…`, each a struct. Kind and first field, the key, name the item; the
// other fields are what must agree. A struct's list of fields is how it is read, written, compared and headed: a new
// kind is one struct and its place in GoldenItem.
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>

#include "base/cell_path.h"
#include "base/hash.h"
#include "biology/lineage.h"

namespace morula {

template <class Item, class Value>
struct GoldenField {
  const char* name;
  Value Item::*value;
};

/// What stands last on a line, blanks and all; may be empty.
struct RestOfLine {
  std::string text;
  friend bool operator==(const RestOfLine&, const RestOfLine&) = default;
};

/// "final/AB/volume", "0.5/organism/cells"
struct ValueName {
  std::optional<double> time;    // [time] of the sample; absent: at the end
  std::optional<CellPath> cell;  // absent: of the organism
  std::string measure;           // [simulation/measures.h]
  friend auto operator<=>(const ValueName&, const ValueName&) = default;
};

// `line`: in the file it was read from; 0: observed.

struct GoldenCount {
  std::string name;
  std::uint64_t count = 0;
  int line = 0;
  static constexpr const char *kind = "count", *check = "counts";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"name", &GoldenCount::name}, GoldenField{"count", &GoldenCount::count});
  }
};

struct GoldenCell {
  CellPath path;
  double born = 0;  // [time]
  std::uint64_t bornStep = 0;
  std::optional<double> ended;  // [time]
  std::optional<std::uint64_t> endedStep;
  Fate fate = Fate::alive;
  RestOfLine state;  // substances
  int line = 0;
  static constexpr const char *kind = "cell", *check = "lineage";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"path", &GoldenCell::path}, GoldenField{"born", &GoldenCell::born},
                      GoldenField{"born_step", &GoldenCell::bornStep}, GoldenField{"ended", &GoldenCell::ended},
                      GoldenField{"ended_step", &GoldenCell::endedStep}, GoldenField{"fate", &GoldenCell::fate},
                      GoldenField{"state", &GoldenCell::state});
  }
};

/// In place of its cells, of which there are too many.
struct GoldenGeneration {
  std::uint64_t number = 0, cells = 0;
  Hash hash;
  int line = 0;
  static constexpr const char *kind = "generation", *check = "lineage";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"number", &GoldenGeneration::number},
                      GoldenField{"cells", &GoldenGeneration::cells}, GoldenField{"hash", &GoldenGeneration::hash});
  }
};

struct GoldenTimeStep {
  std::uint64_t step = 0;
  double time = 0, timeStep = 0;  // [time]
  int line = 0;
  static constexpr const char *kind = "time_step", *check = "time_steps";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"step", &GoldenTimeStep::step}, GoldenField{"time", &GoldenTimeStep::time},
                      GoldenField{"time_step", &GoldenTimeStep::timeStep});
  }
};

struct GoldenBits {
  std::string domain;  // "solver"
  Hash hash;           // of the last state
  int line = 0;
  static constexpr const char *kind = "bits", *check = "bits";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"domain", &GoldenBits::domain}, GoldenField{"hash", &GoldenBits::hash});
  }
};

struct GoldenLink {
  std::uint64_t step = 0;
  Hash hash;
  RestOfLine cells;  // the last four digits of each living cell's hash, by path; none if they are too many
  int line = 0;
  static constexpr const char *kind = "step_hash", *check = "step_hashes";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"step", &GoldenLink::step}, GoldenField{"hash", &GoldenLink::hash},
                      GoldenField{"cells", &GoldenLink::cells});
  }
};

struct GoldenImage {
  std::string name;      // "organism"
  std::string renderer;  // only pictures of one renderer are alike to the bit; one word
  Hash hash;             // of the pixels
  int line = 0;
  static constexpr const char *kind = "image", *check = "images";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"name", &GoldenImage::name}, GoldenField{"renderer", &GoldenImage::renderer},
                      GoldenField{"hash", &GoldenImage::hash});
  }
};

/// A counter that says what the run cost.
struct GoldenCost {
  std::string name;
  std::uint64_t count = 0;
  int line = 0;
  static constexpr const char *kind = "cost", *check = "costs";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"name", &GoldenCost::name}, GoldenField{"count", &GoldenCost::count});
  }
};

struct GoldenValue {
  ValueName name;
  std::uint64_t step = 0;
  double value = 0;
  int line = 0;
  static constexpr const char *kind = "value", *check = "values";
  static constexpr auto fields() {
    return std::tuple(GoldenField{"name", &GoldenValue::name}, GoldenField{"step", &GoldenValue::step},
                      GoldenField{"value", &GoldenValue::value});
  }
};

/// The kinds in their order in the file.
using GoldenItem = std::variant<GoldenCount, GoldenCell, GoldenGeneration, GoldenTimeStep, GoldenBits, GoldenLink,
                                GoldenImage, GoldenCost, GoldenValue>;

// Each value has one text, so that equal text is equal bits and the other way round.
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

// The same bits: −0 and 0 differ.
template <class Value>
bool agree(const Value& a, const Value& b) {
  return a == b;
}
inline bool agree(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool agree(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || agree(*a, *b));
}

/// Calls visit(name, value) for each field of the item.
template <class Item, class Visit>
void visitFields(Item& item, const Visit& visit) {
  std::apply([&](const auto&... field) { (visit(field.name, item.*field.value), ...); },
             std::remove_const_t<Item>::fields());
}
/// Calls visit(name, value, value) for each field of two of one kind.
template <class Item, class Visit>
void visitFields(const Item& a, const Item& b, const Visit& visit) {
  std::apply([&](const auto&... field) { (visit(field.name, a.*field.value, b.*field.value), ...); },
             Item::fields());
}

inline int lineOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return i.line; }, item);
}
inline std::string kindOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return i.kind; }, item);
}
/// The check that compares it.
inline std::string checkOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return i.check; }, item);
}
std::string keyOf(const GoldenItem& item);
/// Kind and key: no two items of a file have the same.
inline std::string idOf(const GoldenItem& item) { return kindOf(item) + ' ' + keyOf(item); }
/// The same in all fields, whatever their lines.
bool agree(const GoldenItem& a, const GoldenItem& b);

/// Splits off the text before the next space; the rest keeps what follows the space.
std::string_view takeWord(std::string_view& rest);

std::string write(const GoldenItem& item);
/// "# cell path born born_step …", so that the file can be read without its description.
std::string headingOf(const GoldenItem& item);
/// Reads one line. Throws InputError that begins with `place` ("file:line").
GoldenItem readItem(std::string_view line, const std::string& place);

/// The step at which the item happened, if it says so.
std::optional<std::uint64_t> stepOf(const GoldenItem& item);
/// The path of the cell it is about, if it is about one; "" is the egg.
std::optional<std::string> cellOf(const GoldenItem& item);

}  // namespace morula
