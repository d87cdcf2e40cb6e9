// Keys for tissues: adhesion by pairs of substances, and connections.
#include <algorithm>
#include <array>

#include "biology/substance_pattern.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

using Pair = std::array<std::string, 2>;

constexpr const char* pairForm = "two substances, or beginnings and '*', as [red, blue]";

std::optional<Pair> readPair(const Node& node, const std::string& path, Reading& reading) {
  if (node.kind != Node::Kind::sequence) {
    refuse(node, path, pairForm, reading.problems);
    return {};
  }
  if (node.items.size() != 2) {
    reading.problems.add(node.place, path,
                         "has " + std::to_string(node.items.size()) + (node.items.size() == 1 ? " entry" : " entries"),
                         std::string("needs ") + pairForm);
    return {};
  }
  const auto a = readPattern(node.items[0], path, reading), b = readPattern(node.items[1], path, reading);
  if (!a || !b) return {};
  return Pair{*a, *b};
}

/// Returns true if the wide pair takes all cells that the narrow one takes.
bool covers(const Pair& wide, const Pair& narrow) {
  return (includes(wide[0], narrow[0]) && includes(wide[1], narrow[1])) ||
         (includes(wide[0], narrow[1]) && includes(wide[1], narrow[0]));
}

/// Returns true, and adds a problem, if an earlier pair covers this one.
bool refuseCovered(const Pair& pair, const std::vector<Pair>& before, const Place& place, const std::string& path,
                   Problems& problems) {
  const auto at = std::ranges::find_if(before, [&](const Pair& wide) { return covers(wide, pair); });
  if (at == before.end()) return false;
  problems.add(place, path, "never counts: [" + (*at)[0] + ", " + (*at)[1] + "] before it takes all of its cells",
               "put it first, or remove one");
  return true;
}

Json pairSchema() { return listSchema({{"type", "string"}, {"minLength", 1}}, 2); }

const std::string strengthAllowed = numberAllowed(notNegative, "force/length");

std::optional<AdhesionPair> readAdhesionPair(const Node& node, const std::string& path, std::vector<Pair>& before,
                                             Reading& reading) {
  const std::string form = "a map, as {of: [red, red], strength: 2}";
  if (node.kind != Node::Kind::map) {
    refuse(node, path, form, reading.problems);
    return {};
  }
  refuseUnknown(node, path, {"of", "strength"}, reading.problems);
  for (const char* key : {"of", "strength"})
    if (!node.find(key)) reading.problems.add(node.place, path + "." + key, "is missing", "needs " + form);
  const Member* of = node.find("of");
  const auto strength = readMember(node, "strength", notNegative, "force/length", path, reading.problems);
  const auto pair = of ? readPair(of->value, path + ".of", reading) : std::nullopt;
  if (!pair || refuseCovered(*pair, before, of->value.place, path + ".of", reading.problems) || !strength) return {};
  before.push_back(*pair);
  return AdhesionPair{(*pair)[0], (*pair)[1], *strength};
}

void readAdhesionMap(const Node& node, const std::string& path, const std::string& allowed,
                     AdhesionParameters& adhesion, Reading& reading) {
  refuseUnknown(node, path, {"default", "pairs"}, reading.problems);
  if (node.members.empty()) reading.problems.add(node.place, path, "is empty", "needs " + allowed);
  if (const auto value = readMember(node, "default", notNegative, "force/length", path, reading.problems))
    adhesion.strength = *value;
  const Member* pairs = node.find("pairs");
  if (!pairs || !expectEntries(pairs->value, path + ".pairs", "a list of maps, as [{of: [red, red], strength: 2}]",
                               reading.problems))
    return;
  std::vector<Pair> before;
  for (std::size_t i = 0; i < pairs->value.items.size(); ++i)
    if (const auto pair =
            readAdhesionPair(pairs->value.items[i], path + ".pairs[" + std::to_string(i) + "]", before, reading))
      adhesion.pairs.push_back(*pair);
}

}  // namespace

Parameter adhesion() {
  Parameter p;
  p.path = "physics.contact.adhesion";
  p.unit = "force/length";
  p.allowed = strengthAllowed + ", or {default: 0.5, pairs: [{of: [red, red], strength: 2}]}";
  p.meaning =
      "Work that parts two cells, per area of contact [Steinberg 1963]: one value for all cells, or values by pairs "
      "of substances (the first pair that fits counts; a name may be the beginning of some and '*') with a default "
      "for the rest; at most a tenth of stiffness and a fifth of membrane.stiffness; not for law thesis";
  p.absent = "cells do not stick to each other";
  const Json strength = numberSchema(notNegative);
  p.schema = {
      {"oneOf",
       Json::array({strength,
                    {{"type", "object"},
                     {"properties",
                      {{"default", strength},
                       {"pairs",
                        {{"type", "array"},
                         {"minItems", 1},
                         {"items", mapSchema({{"of", pairSchema()}, {"strength", strength}}, {"of", "strength"})}}}}},
                     {"minProperties", 1},
                     {"additionalProperties", false}}})}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    AdhesionParameters adhesion;
    if (node.kind == Node::Kind::map) {
      readAdhesionMap(node, path, allowed, adhesion, reading);
    } else {
      const auto value = readReal(node, notNegative, path, allowed, reading.problems);
      if (!value) return;
      adhesion.strength = *value;
    }
    s.scene.mechanics->contact->adhesion = std::move(adhesion);
  };
  p.write = [](const Scenario& s) {
    const auto& adhesion = s.scene.mechanics->contact->adhesion;
    if (!adhesion) return Json();
    if (adhesion->pairs.empty()) return Json(adhesion->strength);
    Json pairs = Json::array();
    for (const auto& [a, b, own] : adhesion->pairs) pairs.push_back({{"of", Json::array({a, b})}, {"strength", own}});
    return Json{{"default", adhesion->strength}, {"pairs", pairs}};
  };
  return p;
}

Parameter makeConnections() {
  std::vector<std::string> words;
  std::string meaning;
  for (const auto& row : choices<MakeConnections>) {
    if (row.value != MakeConnections::pairs) words.push_back(row.name);
    meaning += (meaning.empty() ? "" : "; ") + std::string(row.name) + ": " + row.meaning;
  }
  // The words stand first among the values; pairs, which takes a list, behind them.
  Parameter p = oneOf("connections.make", words, meaning, nullptr, [](Scenario& s, int value) {
    s.scene.mechanics->connections->make = choices<MakeConnections>[value].value;
  });
  p.allowed += ", or {pairs: [[red, blue]]}";
  const Json list{{"type", "array"}, {"items", pairSchema()}, {"minItems", 1}};
  p.schema = {{"oneOf", Json::array({p.schema, onlySchema("pairs", list)})}};
  p.read = [readWord = p.read, path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind != Node::Kind::map) return readWord(s, node, reading);
    const Member* only = readOnly(node, path, {"pairs"}, allowed, reading.problems);
    if (!only) return;
    ConnectionParameters& c = *s.scene.mechanics->connections;
    const std::string at = path + ".pairs";
    c.make = MakeConnections::pairs;
    if (!expectEntries(only->value, at, "a list of pairs, as [[red, blue]]", reading.problems)) return;
    std::vector<Pair> before;
    for (const Node& item : only->value.items) {
      const auto pair = readPair(item, at, reading);
      if (!pair || refuseCovered(*pair, before, item.place, at, reading.problems)) continue;
      before.push_back(*pair);
      c.pairs.push_back({(*pair)[0], (*pair)[1]});
    }
  };
  p.write = [](const Scenario& s) {
    const ConnectionParameters& c = *s.scene.mechanics->connections;
    if (c.make != MakeConnections::pairs) return Json(nameOf(c.make));
    Json pairs = Json::array();
    for (const auto& [a, b] : c.pairs) pairs.push_back(Json::array({a, b}));
    return Json{{"pairs", pairs}};
  };
  return p;
}

}  // namespace morula::scenario
