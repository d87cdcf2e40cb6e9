#include "scenario/value_types.h"

#include <algorithm>
#include <cmath>

#include "base/did_you_mean.h"

namespace morula::scenario {

namespace {

std::string withUnit(std::string allowed, const std::string& unit) {
  return unit.empty() ? allowed : allowed + " [" + unit + "]";
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

/// Texts may be quoted, and may look like numbers.
std::optional<std::string> readText(const Node& node, const std::string& path, const std::string& allowed,
                                    Problems& problems) {
  if (node.kind == Node::Kind::broken) return {};
  if (node.kind != Node::Kind::scalar) {
    problems.add(node.place, path, node.kind == Node::Kind::null ? "is empty" : "is " + describe(node),
                 "needs " + allowed);
    return {};
  }
  return node.text;
}

bool isName(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !text.empty() && text.size() <= 100 && text[0] != '-' && std::all_of(text.begin(), text.end(), fits);
}

/// Calls `read` for each member of a map whose keys are substances.
template <class Read>
void readPerSubstance(const Node& node, const std::string& path, const std::string& allowed, Reading& reading,
                      Read read) {
  if (node.kind == Node::Kind::broken) return;
  if (node.kind != Node::Kind::map) {
    reading.problems.add(node.place, path,
                         node.kind == Node::Kind::null ? "is empty" : "is " + describe(node),
                         "needs " + allowed);
    return;
  }
  for (const auto& member : node.members) {
    if (member.key.empty()) continue;
    reading.substances.push_back({member.key, member.place, path});
    read(member, path + "." + member.key);
  }
}

}  // namespace

std::optional<double> readReal(const Node& node, const Range& range, const std::string& path,
                               const std::string& allowed, Problems& problems) {
  if (!expectPlain(node, path, allowed, problems)) return {};
  const auto number = parseReal(node.text);
  if (!number.wrong.empty())
    problems.add(node.place, path, describe(node) + " " + number.wrong, "needs " + allowed);
  else if (!range.holds(number.value))
    problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
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

Parameter text(std::string path, std::string meaning, Field<std::string> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = "a text";
  p.meaning = std::move(meaning);
  p.schema = {{"type", "string"}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (auto value = readText(node, path, allowed, reading.problems)) field(s) = std::move(*value);
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter name(std::string path, std::string meaning, Field<std::string> field) {
  auto p = text(std::move(path), std::move(meaning), field);
  p.allowed = "a name made of letters, digits, '-' and '_'";
  p.schema["pattern"] = "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$";
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    if (!isName(*value))
      reading.problems.add(node.place, path, describe(node) + " is not a name", "needs " + allowed);
    else field(s) = *value;
  };
  return p;
}

Parameter optionalFile(std::string path, std::string meaning, Field<std::optional<std::string>> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = "a file, relative to the scenario's folder";
  p.meaning = std::move(meaning);
  p.absent = "none";
  p.schema = {{"type", "string"}, {"minLength", 1}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    if (value->empty()) reading.problems.add(node.place, path, "is empty", "needs " + allowed);
    else field(s) = std::move(*value);
  };
  p.write = [field](const Scenario& s) {
    const auto& value = field(const_cast<Scenario&>(s));
    return value ? Json(*value) : Json();
  };
  return p;
}

Parameter timePerSubstance(std::string path, std::string meaning,
                           Field<std::map<std::string, double>> field) {
  Parameter p;
  p.path = std::move(path);
  p.unit = "time";
  p.allowed = "a map of substances to numbers > 0 [time]";
  p.meaning = std::move(meaning);
  p.schema = {{"type", "object"}, {"additionalProperties", numberSchema(positive)}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    readPerSubstance(node, path, allowed, reading, [&](const Member& member, const std::string& at) {
      const auto value =
          readReal(member.value, positive, at, numberAllowed(positive, "time"), reading.problems);
      if (value) field(s)[member.key] = *value;
    });
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter colourPerSubstance(std::string path, std::string meaning,
                             Field<std::map<std::string, std::string>> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = "a map of substances, or beginnings of names and '*', to colours '#rrggbb'";
  p.meaning = std::move(meaning);
  p.decides = Decides::presentation;
  p.schema = {{"type", "object"},
              {"additionalProperties", {{"type", "string"}, {"pattern", "^#[0-9A-Fa-f]{6}$"}}}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    readPerSubstance(node, path, allowed, reading, [&](const Member& member, const std::string& at) {
      const std::string form = "a colour '#rrggbb', in quotes because '#' begins a comment";
      const auto value = readText(member.value, at, form, reading.problems);
      if (!value) return;
      std::string colour = *value;
      bool good = colour.size() == 7 && colour[0] == '#';
      for (auto& c : colour) {
        if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
        good = good && (&c == &colour[0] || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'));
      }
      if (good) field(s)[member.key] = colour;
      else
        reading.problems.add(member.value.place, at, describe(member.value) + " is not a colour",
                             "needs " + form);
    });
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter choiceOf(std::string path, std::vector<std::string> names, std::string meaning,
                   std::function<int(Scenario&)> get, std::function<void(Scenario&, int)> set) {
  Parameter p;
  p.path = std::move(path);
  for (const auto& name : names)
    p.allowed += (p.allowed.empty() ? "" : &name == &names.back() ? " or " : ", ") + name;
  p.meaning = std::move(meaning);
  p.schema = {{"enum", names}};
  p.read = [set, names, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    const auto value = readText(node, path, allowed, reading.problems);
    if (!value) return;
    const auto found = std::find(names.begin(), names.end(), *value);
    if (found != names.end()) return set(s, static_cast<int>(found - names.begin()));
    const auto near = closest(*value, names);
    reading.problems.add(node.place, path, describe(node) + " is not known here",
                         near.empty() ? "needs " + allowed : "did you mean " + near + "? Needs " + allowed);
  };
  p.write = [get, names](const Scenario& s) { return Json(names[get(const_cast<Scenario&>(s))]); };
  return p;
}

}  // namespace morula::scenario
