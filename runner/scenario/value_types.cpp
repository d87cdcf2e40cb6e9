#include "scenario/value_types.h"

#include <algorithm>
#include <cmath>

namespace morula::scenario {

namespace {

std::string withUnit(std::string allowed, const std::string& unit) {
  return unit.empty() ? allowed : allowed + " [" + unit + "]";
}

std::string naturalAllowed(const NaturalRange& range) {
  if (range.low == range.high) return std::to_string(range.low);
  return "a whole number from " + std::to_string(range.low) + " to " + std::to_string(range.high);
}

/// Says what is wrong with a node that is no plain scalar where one is needed; true if it was one.
bool expectPlain(const Node& node, const std::string& path, const std::string& allowed, Problems& problems) {
  if (node.isPlain()) return true;
  if (node.kind == Node::Kind::broken) return false;
  if (node.kind == Node::Kind::null) problems.add(node.place, path, "is empty", "needs " + allowed);
  else if (node.kind == Node::Kind::scalar)
    problems.add(node.place, path, describe(node) + " is in quotes", "needs " + allowed + ", without quotes");
  else problems.add(node.place, path, "is " + describe(node), "needs " + allowed);
  return false;
}

std::optional<std::uint64_t> readNatural(const Node& node, const NaturalRange& range, const std::string& path,
                                         const std::string& allowed, Problems& problems) {
  if (!expectPlain(node, path, allowed, problems)) return {};
  const auto number = parseNatural(node.text);
  if (!number.wrong.empty())
    problems.add(node.place, path, describe(node) + " " + number.wrong, "needs " + allowed);
  else if (number.value < range.low || number.value > range.high)
    problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
  else return number.value;
  return {};
}

}  // namespace

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

std::optional<double> readReal(const Node& node, const Range& range, const std::string& path,
                               const std::string& allowed, Problems& problems) {
  if (!expectPlain(node, path, allowed, problems)) return {};
  const auto number = parseReal(node.text);
  if (!number.wrong.empty())
    problems.add(node.place, path, describe(node) + " " + number.wrong, "needs " + allowed);
  else if (!range.holds(number.value))
    problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
  else if (range.ordinary && number.value != 0 && !ordinaryNumbers.holds(number.value))
    problems.add(node.place, path, node.text + " is out of range",
                 "needs " + allowed + (range.openLow ? ", " : ", 0 or ") + ordinaryNumbers.text());
  else return number.value;
  return {};
}

std::optional<Vector> readTriple(const Node& node, const Range& range, const std::string& path,
                                 const std::string& allowed, Problems& problems) {
  if (node.kind == Node::Kind::broken) return {};
  if (node.kind != Node::Kind::sequence || node.items.size() != 3) {
    const auto what = node.kind == Node::Kind::sequence
                          ? "has " + std::to_string(node.items.size()) + " entries"
                      : node.kind == Node::Kind::null ? "is empty"
                                                      : "is " + describe(node);
    problems.add(node.place, path, what, "needs " + allowed);
    return {};
  }
  const auto x = readReal(node.items[0], range, path, allowed, problems);
  const auto y = readReal(node.items[1], range, path, allowed, problems);
  const auto z = readReal(node.items[2], range, path, allowed, problems);
  if (x && y && z) return Vector{*x, *y, *z};
  return {};
}

Parameter real(std::string path, std::string unit, Range range, std::string meaning, Field<double> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = numberAllowed(range, unit);
  p.unit = std::move(unit);
  p.meaning = std::move(meaning);
  p.schema = numberSchema(range);
  p.read = [field, range, path = p.path, allowed = p.allowed](Scenario& s, const Node& node,
                                                              Reading& reading) {
    if (const auto value = readReal(node, range, path, allowed, reading.problems)) field(s) = *value;
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter optionalReal(std::string path, std::string unit, Range range, std::string word, std::string absent,
                       std::string meaning, Field<std::optional<double>> field) {
  auto p = real(std::move(path), std::move(unit), range, std::move(meaning), nullptr);
  p.absent = std::move(absent);
  if (!word.empty()) {
    p.allowed += ", or " + word;
    p.schema = {{"oneOf", Json::array({p.schema, {{"const", word}}})}};
  }
  p.read = [field, range, word, path = p.path, allowed = p.allowed](Scenario& s, const Node& node,
                                                                    Reading& reading) {
    if (!word.empty() && node.kind == Node::Kind::scalar && node.text == word) field(s) = std::nullopt;
    else if (const auto value = readReal(node, range, path, allowed, reading.problems)) field(s) = *value;
  };
  p.write = [field, word](const Scenario& s) {
    const auto& value = field(const_cast<Scenario&>(s));
    return value ? Json(*value) : word.empty() ? Json() : Json(word);
  };
  return p;
}

Parameter natural(std::string path, NaturalRange range, std::string meaning, Field<std::uint64_t> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = naturalAllowed(range);
  p.meaning = std::move(meaning);
  p.schema = {{"type", "integer"}, {"minimum", range.low}, {"maximum", range.high}};
  p.read = [field, range, path = p.path, allowed = p.allowed](Scenario& s, const Node& node,
                                                              Reading& reading) {
    if (const auto value = readNatural(node, range, path, allowed, reading.problems)) field(s) = *value;
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter optionalNatural(std::string path, NaturalRange range, std::string absent, std::string meaning,
                          Field<std::optional<std::uint64_t>> field) {
  auto p = natural(std::move(path), range, std::move(meaning), nullptr);
  p.absent = std::move(absent);
  p.read = [field, range, path = p.path, allowed = p.allowed](Scenario& s, const Node& node,
                                                              Reading& reading) {
    if (const auto value = readNatural(node, range, path, allowed, reading.problems)) field(s) = *value;
  };
  p.write = [field](const Scenario& s) {
    const auto& value = field(const_cast<Scenario&>(s));
    return value ? Json(*value) : Json();
  };
  return p;
}

}  // namespace morula::scenario
