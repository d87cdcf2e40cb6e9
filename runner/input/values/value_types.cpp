#include "values/value_types.h"

#include <algorithm>
#include <cmath>

#include "base/did_you_mean.h"
#include "files/text.h"

namespace morula::scenario {
namespace {

std::string withUnit(std::string allowed, const std::string& unit) {
  return unit.empty() ? allowed : allowed + " [" + unit + "]";
}

std::string naturalAllowed(const NaturalRange& range) {
  if (range.low == range.high) return std::to_string(range.low);
  return "a whole number from " + std::to_string(range.low) + " to " + std::to_string(range.high);
}

/// Returns true for a plain scalar, and adds a problem for anything else.
bool expectPlain(const Node& node, const std::string& path, const std::string& allowed, Problems& problems) {
  if (node.isPlain()) return true;
  if (node.kind == Node::Kind::scalar)
    problems.add(node.place, path, describe(node) + " is in quotes", "needs " + allowed + ", without quotes");
  else refuse(node, path, allowed, problems);
  return false;
}

}  // namespace

std::optional<std::uint64_t> readNatural(const Node& node, const NaturalRange& range, const std::string& path,
                                         const std::string& allowed, Problems& problems) {
  if (!expectPlain(node, path, allowed, problems)) return {};
  const auto number = parseNatural(node.text);
  if (!number.wrong.empty()) problems.add(node.place, path, describe(node) + " " + number.wrong, "needs " + allowed);
  else if (number.value < range.low || number.value > range.high)
    problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
  else return number.value;
  return {};
}

void refuse(const Node& node, const std::string& path, const std::string& allowed, Problems& problems) {
  if (node.kind == Node::Kind::broken) return;
  problems.add(node.place, path, node.kind == Node::Kind::null ? "is empty" : "is " + describe(node),
               "needs " + allowed);
}

void refuseUnknown(const Node& node, const std::string& path, const std::vector<std::string>& keys,
                   Problems& problems) {
  for (const auto& member : node.members) {
    if (member.key.empty() || std::find(keys.begin(), keys.end(), member.key) != keys.end()) continue;
    const std::string meant = closest(member.key, keys);
    problems.add(member.place, path + "." + member.key, "unknown key",
                 meant.empty() ? "known here: " + join(keys) : "did you mean " + meant + "?");
  }
}

const Member* readOnly(const Node& node, const std::string& path, const std::vector<std::string>& keys,
                       const std::string& allowed, Problems& problems) {
  const Member* found = nullptr;
  refuseUnknown(node, path, keys, problems);
  for (const auto& member : node.members) {
    if (std::find(keys.begin(), keys.end(), member.key) == keys.end()) continue;
    if (found) problems.add(member.place, path + "." + member.key, "is one too many", "needs " + allowed);
    else found = &member;
  }
  if (node.members.empty()) problems.add(node.place, path, "is empty", "needs " + allowed);
  return found;
}

bool expectEntries(const Node& node, const std::string& path, const std::string& allowed, Problems& problems) {
  if (node.kind != Node::Kind::sequence) refuse(node, path, allowed, problems);
  else if (node.items.empty()) problems.add(node.place, path, "is empty", "needs " + allowed);
  return !node.items.empty();
}

std::string numberAllowed(const Range& range, const std::string& unit) {
  const auto interval = range.text();
  return withUnit(interval.empty() ? "a number" : "a number " + interval, unit);
}

Json numberSchema(const Range& range) {
  Json schema{{"type", "number"}};
  if (std::isfinite(range.low)) schema[range.openLow ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) schema["maximum"] = range.high;
  return schema;
}

Json listSchema(const Json& items, int count) {
  return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

Json mapSchema(const Json& members, const std::vector<std::string>& required) {
  Json schema{{"type", "object"}, {"properties", members}};
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

Json onlySchema(const std::string& key, const Json& value) { return mapSchema({{key, value}}, {key}); }

std::optional<double> readReal(const Node& node, const Range& range, const std::string& path,
                               const std::string& allowed, Problems& problems) {
  if (!expectPlain(node, path, allowed, problems)) return {};
  const auto number = parseReal(node.text);
  if (!number.wrong.empty()) problems.add(node.place, path, describe(node) + " " + number.wrong, "needs " + allowed);
  else if (!range.holds(number.value))
    problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
  else if (range.ordinary && number.value != 0 && !ordinaryNumbers.holds(number.value))
    problems.add(node.place, path, node.text + " is out of range",
                 "needs " + allowed + (range.openLow ? ", " : ", 0 or ") + ordinaryNumbers.text());
  else return number.value;
  return {};
}

std::optional<double> readMember(const Node& map, const std::string& key, const Range& range, const std::string& unit,
                                 const std::string& path, Problems& problems) {
  const Member* member = map.find(key);
  if (!member) return {};
  return readReal(member->value, range, path + "." + key, numberAllowed(range, unit), problems);
}

std::optional<std::vector<double>> readReals(const Node& node, std::size_t count, const Range& range,
                                             const std::string& path, const std::string& allowed, Problems& problems) {
  if (node.kind != Node::Kind::sequence) return refuse(node, path, allowed, problems), std::nullopt;
  if (node.items.size() != count) {
    problems.add(node.place, path, "has " + std::to_string(node.items.size()) + " entries", "needs " + allowed);
    return {};
  }
  std::vector<double> values;
  for (const Node& item : node.items)
    if (const auto value = readReal(item, range, path, allowed, problems)) values.push_back(*value);
  return values.size() == count ? std::optional(values) : std::nullopt;
}

std::optional<Vector> readTriple(const Node& node, const Range& range, const std::string& path,
                                 const std::string& allowed, Problems& problems) {
  const auto v = readReals(node, 3, range, path, allowed, problems);
  return v ? std::optional(Vector{v->at(0), v->at(1), v->at(2)}) : std::nullopt;
}

std::optional<Vector> readAxis(const Node& node, const std::string& path, Problems& problems) {
  const auto axis = readTriple(node, {}, path, "three numbers, not all 0, as [1, 0, 0]", problems);
  if (!axis || *axis != Vector{}) return axis;
  problems.add(node.place, path, "has length 0", "needs at least one number other than 0");
  return {};
}

Parameter presented(std::string path, std::string allowed, std::string absent, std::string meaning) {
  return {.path = std::move(path),
          .allowed = std::move(allowed),
          .meaning = std::move(meaning),
          .decides = Decides::presentation,
          .absent = std::move(absent)};
}

Parameter real(std::string path, std::string unit, Range range, std::string meaning, Field<double> field) {
  return ofField({.path = std::move(path),
                  .unit = unit,
                  .allowed = numberAllowed(range, unit),
                  .meaning = std::move(meaning),
                  .schema = numberSchema(range)},
                 field, [range](const Node& node, auto&... at) { return readReal(node, range, at...); });
}

Parameter optionalReal(std::string path, std::string unit, Range range, std::string word, std::string absent,
                       std::string meaning, Field<std::optional<double>> field) {
  auto p = real(std::move(path), std::move(unit), range, std::move(meaning), nullptr);
  p.absent = std::move(absent);
  if (!word.empty()) {
    p.allowed += ", or " + word;
    p.schema = {{"oneOf", Json::array({p.schema, {{"const", word}}})}};
  }
  p.read = [field, range, word, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (!word.empty() && node.kind == Node::Kind::scalar && node.text == word) field(s) = std::nullopt;
    else if (const auto value = readReal(node, range, path, allowed, reading.problems)) field(s) = *value;
  };
  p.write = [field, word](const Scenario& s) {
    const auto& value = field(const_cast<Scenario&>(s));
    return value ? Json(*value) : word.empty() ? Json() : Json(word);
  };
  return p;
}

namespace {

template <class T>
Parameter naturalOf(std::string path, NaturalRange range, std::string absent, std::string meaning, Field<T> field) {
  return ofField({.path = std::move(path),
                  .allowed = naturalAllowed(range),
                  .meaning = std::move(meaning),
                  .schema = {{"type", "integer"}, {"minimum", range.low}, {"maximum", range.high}},
                  .absent = std::move(absent)},
                 field, [range](const Node& node, auto&... at) { return readNatural(node, range, at...); });
}

}  // namespace

Parameter natural(std::string path, NaturalRange range, std::string meaning, Field<std::uint64_t> field) {
  return naturalOf(std::move(path), range, "", std::move(meaning), field);
}

Parameter optionalNatural(std::string path, NaturalRange range, std::string absent, std::string meaning,
                          Field<std::optional<std::uint64_t>> field) {
  return naturalOf(std::move(path), range, std::move(absent), std::move(meaning), field);
}

}  // namespace morula::scenario
