// Maps from substances to values.
#include "values/value_types.h"

namespace morula::scenario {
namespace {

/// Calls `read` for each member of a map whose keys are substances; with `patterns`, also patterns.
template <class Read>
void readPerSubstance(const Node& node, const std::string& path, const std::string& allowed, bool patterns,
                      Reading& reading, Read read) {
  if (node.kind != Node::Kind::map) return refuse(node, path, allowed, reading.problems);
  for (const auto& member : node.members) {
    if (member.key.empty()) continue;
    const bool isPattern = patterns && member.key.ends_with('*');
    reading.substances.push_back({member.key, member.place, path + "." + member.key, isPattern});
    read(member, path + "." + member.key);
  }
}

}  // namespace

std::optional<std::string> readPattern(const Node& node, const std::string& path, Reading& reading) {
  const std::string allowed = "a substance, or the beginning of some and '*', in quotes";
  const auto name = readText(node, path, allowed, reading.problems);
  if (!name) return {};
  if (name->empty() || name->find_first_of("* ") < name->size() - 1) {
    reading.problems.add(node.place, path, describe(node) + " is no substance", "needs " + allowed);
    return {};
  }
  reading.substances.push_back({*name, node.place, path, name->ends_with('*')});
  return name;
}

Parameter timePerSubstance(std::string path, std::string meaning, Field<std::map<std::string, double>> field) {
  Parameter p;
  p.path = std::move(path);
  p.unit = "time";
  p.allowed = "a map of substances, or beginnings of names and '*', to numbers > 0 [time]";
  p.meaning = std::move(meaning);
  p.schema = {{"type", "object"}, {"additionalProperties", numberSchema(positive)}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    readPerSubstance(node, path, allowed, true, reading, [&](const Member& member, const std::string& at) {
      const auto value = readReal(member.value, positive, at, numberAllowed(positive, "time"), reading.problems);
      if (value) field(s)[member.key] = *value;
    });
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

Parameter colourPerSubstance(std::string path, std::string meaning, Field<std::map<std::string, std::string>> field) {
  Parameter p;
  p.path = std::move(path);
  p.allowed = "a map of substances, or beginnings of names and '*', to colours '#rrggbb'";
  p.meaning = std::move(meaning);
  p.decides = Decides::presentation;
  p.schema = {{"type", "object"}, {"additionalProperties", {{"type", "string"}, {"pattern", "^#[0-9A-Fa-f]{6}$"}}}};
  p.read = [field, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    readPerSubstance(node, path, allowed, true, reading, [&](const Member& member, const std::string& at) {
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
      else reading.problems.add(member.value.place, at, describe(member.value) + " is not a colour", "needs " + form);
    });
  };
  p.write = [field](const Scenario& s) { return Json(field(const_cast<Scenario&>(s))); };
  return p;
}

}  // namespace morula::scenario
