#include "golden/item.h"

#include <cmath>

#include "base/error.h"
#include "base/hash.h"
#include "golden/read_number.h"

namespace morula {
namespace {

// Each `read` reads a value from a text. It returns null, or the form that would have been right.

const char* read(std::string_view text, std::uint64_t& value) {
  const auto number = readNatural(text);
  if (number) value = *number;
  return number ? nullptr : "a whole number from 0";
}

const char* read(std::string_view text, double& value) {
  const auto number = readReal(text);
  if (number) value = *number;
  return number && std::isfinite(*number) && exactText(*number) == text
             ? nullptr
             : "a finite number, written as shortly as it can be";
}

const char* read(std::string_view text, Hash& value) {
  const auto hash = readHash(text);
  if (hash) value = *hash;
  return hash ? nullptr : "a hash of 32 hexadecimal digits";
}

const char* read(std::string_view text, Fate& value) {
  for (const Fate fate : {Fate::alive, Fate::divided, Fate::died})
    if (text == name(fate)) return value = fate, nullptr;
  return "alive, divided or died";
}

const char* read(std::string_view text, CellPath& value) {
  if (text != "egg") value = CellPath::parse(std::string(text));
  return text.empty() ? "a cell's path, or egg," : nullptr;
}

const char* read(std::string_view text, ValueName& value) {
  const char* const form = "WHEN/WHO/WHAT, as final/AB/volume,";
  const std::size_t first = text.find('/'), last = text.rfind('/');
  if (first == text.npos || last == first || last + 1 == text.size()) return form;
  const std::string_view when = text.substr(0, first), who = text.substr(first + 1, last - first - 1);
  value.measure = text.substr(last + 1);
  if (when != "final" && read(when, value.time.emplace())) return form;
  return who == "organism" ? nullptr : read(who, value.cell.emplace());
}

const char* read(std::string_view text, std::string& value) { return value = text, nullptr; }
const char* read(std::string_view text, RestOfLine& value) { return value.text = text, nullptr; }

template <class Value>
const char* read(std::string_view text, std::optional<Value>& value) {
  return text == "-" ? nullptr : read(text, value.emplace());
}

template <class Item>
Item readAs(std::string_view line, const std::string& place) {
  Item item;
  bool isKey = true;
  const auto readField = [&]<class Value>(const std::string& name, Value& value) {
    constexpr bool takesAll = std::is_same_v<Value, RestOfLine>;
    const std::string_view given = takesAll ? std::exchange(line, {}) : takeWord(line);
    if (given.empty() && !takesAll)
      throw InputError(place + (isKey ? ": the line ends after its kind; its " : ": the line is cut short; ") + name +
                       " is expected");
    isKey = false;
    const char* right = nullptr;
    try {
      right = read(given, value);
    } catch (const InputError& e) { throw InputError(place + ": path: " + e.what()); }
    if (right) throw InputError(place + ": " + name + ": '" + std::string(given) + "'; " + right + " is expected");
  };
  visitGoldenFields(readField, item);
  if (!line.empty()) throw InputError(place + ": '" + std::string(line) + "' follows the end of the line; remove it");
  return item;
}

}  // namespace

std::string goldenText(std::uint64_t value) { return std::to_string(value); }
std::string goldenText(double value) { return exactText(value); }
std::string goldenText(const Hash& value) { return value.text(); }
std::string goldenText(const CellPath& value) { return value.isEgg() ? "egg" : value.text(); }
std::string goldenText(const ValueName& value) {
  return (value.time ? exactText(*value.time) : "final") + '/' + (value.cell ? goldenText(*value.cell) : "organism") +
         '/' + value.measure;
}

std::string_view takeWord(std::string_view& rest) {
  const std::size_t space = rest.find(' ');
  const std::string_view word = rest.substr(0, space);
  rest = space == std::string_view::npos ? std::string_view() : rest.substr(space + 1);
  return word;
}

std::string fieldNames(std::string_view members) {
  std::string names;
  for (const char c : members.substr(0, members.rfind(", ")))
    if (c >= 'A' && c <= 'Z') names += {'_', static_cast<char>(c - 'A' + 'a')};
    else if (c != ',') names += c;
  return names;
}

std::string kindOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return i.kind; }, item);
}

std::string keyOf(const GoldenItem& item) {
  return std::visit([](const auto& i) { return goldenText(std::get<0>(members(i))); }, item);
}

bool agree(const GoldenItem& a, const GoldenItem& b) {
  if (a.index() != b.index()) return false;
  bool same = true;
  const auto compare = [&](const std::string&, const auto& x, const auto& y) { same = same && agree(x, y); };
  std::visit([&]<class Item>(const Item& i) { visitGoldenFields(compare, i, std::get<Item>(b)); }, a);
  return same;
}

std::string write(const GoldenItem& item) {
  std::string line = kindOf(item);
  const auto add = [&](const std::string&, const auto& value) {
    if (const std::string text = goldenText(value); !text.empty()) line += ' ' + text;
  };
  std::visit([&](const auto& i) { visitGoldenFields(add, i); }, item);
  return line;
}

std::string headingOf(const GoldenItem& item) {
  std::string heading = "# " + kindOf(item);
  const auto add = [&](const std::string& name, const auto&) { heading += ' ' + name; };
  std::visit([&](const auto& i) { visitGoldenFields(add, i); }, item);
  return heading;
}

GoldenItem readItem(std::string_view line, const std::string& place) {
  const std::string_view kind = takeWord(line);
  std::optional<GoldenItem> item;
  std::string kinds;
  const auto tryAs = [&]<class Item>(const Item& empty) {
    if constexpr (std::is_same_v<Item, OldGoldenError>) {
      if (kind == empty.kind && isOldError(line)) item = readAs<Item>(line, place);
      return;
    }
    if (kind == kindOf(empty) && !item) item = readAs<Item>(line, place);
    kinds += (kinds.empty() ? "" : ", ") + kindOf(empty);
  };
  [&]<class... Items>(const std::variant<Items...>*) { (tryAs(Items{}), ...); }(static_cast<GoldenItem*>(nullptr));
  if (!item)
    throw InputError(place + ": '" + std::string(kind) + "' begins no line of a golden file; one of " + kinds +
                     " is expected");
  return *item;
}

std::optional<std::uint64_t> stepOf(const GoldenItem& item) {
  if (const auto* cell = std::get_if<GoldenCell>(&item)) return cell->bornStep;
  return std::visit(
      [](const auto& i) -> std::optional<std::uint64_t> {
        if constexpr (requires { i.step; }) return i.step;
        return {};
      },
      item);
}

std::optional<std::string> cellOf(const GoldenItem& item) {
  if (const auto* cell = std::get_if<GoldenCell>(&item)) return cell->path.text();
  const auto* value = std::get_if<GoldenValue>(&item);
  return value && value->name.cell ? std::optional(value->name.cell->text()) : std::nullopt;
}

}  // namespace morula
