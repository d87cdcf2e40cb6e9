// The names of cells: keys, the file, and whether each name means one cell.
#include <algorithm>

#include "base/error.h"
#include "values/value_types.h"
#include "values/word_file.h"

namespace morula::scenario {
namespace {

constexpr const char* pathAllowed = "1 to 120 letters A and B";

Json nameSchema() { return {{"type", "string"}, {"minLength", 1}, {"maxLength", 40}}; }

std::optional<CellPath> pathIn(std::string_view text) {
  const bool good = !text.empty() && text.size() <= CellPath::maxDepth && text.find_first_not_of("AB") == text.npos;
  return good ? std::optional(CellPath::parse(text)) : std::nullopt;
}

std::optional<std::string> readName(const Node& node, const std::string& path, const std::string& allowed,
                                    Problems& problems) {
  auto value = readText(node, path, allowed, problems);
  if (!value || isCellName(*value)) return value;
  problems.add(node.place, path, describe(node) + " is no name of a cell", "needs " + allowed);
  return {};
}

/// Returns "names.cells.AB", or for a name from a file its line there.
std::string whereOf(const NameUse& use) { return use.inFile.empty() ? use.key : use.inFile; }

void complain(const NameUse& use, const std::string& wrong, const std::string& right, Problems& problems) {
  if (use.inFile.empty()) problems.add(use.place, use.key, wrong, right);
  else problems.addForeign(use.place, use.inFile + ": " + wrong + "; " + right);
}

std::string words(const CellPath& path) { return path.isEgg() ? "the egg" : "path " + path.text(); }

}  // namespace

void nameCell(const NameUse& use, const std::string& name, Scenario& scenario, Reading& reading) {
  if (scenario.names.given.try_emplace(use.path, name).second) return reading.names.push_back(use);
  const auto first = std::ranges::find(reading.names, use.path, &NameUse::path);
  complain(use, cellName(use.path.text()) + " is named here and in " + whereOf(*first), "keep one of the two",
           reading.problems);
}

Parameter nameOfEgg() {
  auto p = presented("names.egg", nameAllowed, "the egg has no name", "Name of the egg, as P0");
  p.schema = nameSchema();
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (const auto name = readName(node, path, allowed, reading.problems))
      nameCell({{}, node.place, path, ""}, *name, s, reading);
  };
  p.write = [](const Scenario& s) {
    const auto egg = s.names.given.find({});
    return egg == s.names.given.end() ? Json() : Json(egg->second);
  };
  return p;
}

Parameter namesOfDaughters() {
  auto p = presented("names.daughters", "two names' endings, as [a, p], of which neither begins with the other",
                     "cells that have no name of their own have none",
                     "Endings that daughter A and daughter B add to their mother's name");
  p.schema = listSchema(nameSchema(), 2);
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    auto& problems = reading.problems;
    if (!expectEntries(node, path, allowed, problems)) return;
    if (node.items.size() != 2)
      return problems.add(node.place, path, "has " + std::to_string(node.items.size()) + " entries",
                          "needs " + allowed);
    std::vector<std::string> endings;
    for (const Node& item : node.items)
      if (const auto ending = readName(item, path, nameAllowed, problems)) endings.push_back(*ending);
    if (endings.size() < 2) return;
    if (endings[0].starts_with(endings[1]) || endings[1].starts_with(endings[0]))
      return problems.add(node.place, path, "one ending begins with the other, so names would be ambiguous",
                          "needs " + allowed);
    s.names.daughters = endings;
  };
  p.write = [](const Scenario& s) { return s.names.daughters.empty() ? Json() : Json(s.names.daughters); };
  return p;
}

Parameter namesOfCells() {
  auto p = presented("names.cells", "a map of paths to names, as {A: AB, B: P1}", "none",
                     "Names of cells by their paths; the egg's is names.egg");
  p.schema = {
      {"type", "object"}, {"propertyNames", {{"pattern", "^[AB]{1,120}$"}}}, {"additionalProperties", nameSchema()}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind != Node::Kind::map) return refuse(node, path, allowed, reading.problems);
    for (const Member& member : node.members) {
      const auto cell = pathIn(member.key);
      const std::string key = path + "." + member.key;
      if (!cell && !member.key.empty())
        reading.problems.add(member.place, key, "is not a cell's path", std::string("needs ") + pathAllowed);
      const auto name = readName(member.value, key, nameAllowed, reading.problems);
      if (cell && name) nameCell({*cell, member.place, key, ""}, *name, s, reading);
    }
  };
  p.write = [](const Scenario& s) {
    Json cells = Json::object();
    for (const auto& [path, name] : s.names.given)
      if (!path.isEgg()) cells[path.text()] = name;
    return cells.empty() ? Json() : cells;
  };
  return p;
}

Parameter namesFile() {
  auto p = presented("names.file", "a file, relative to the scenario's folder", "none",
                     "More names, one 'PATH NAME' a line, 'egg' for the egg's path; '#' begins a comment");
  p.schema = {{"type", "string"}, {"minLength", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    if (const auto file = readWords(node, path, allowed, reading.problems)) reading.namesFile = {*file, node.place};
  };
  p.write = [](const Scenario&) { return Json(); };  // written as names.cells
  return p;
}

void readCellNames(const std::string& text, const std::string& file, const Place& place, Scenario& scenario,
                   Reading& reading) {
  const std::size_t before = reading.problems.size();
  for (const auto& [line, column, found] : readWordFile(text, file, place, reading.problems)) {
    NameUse use{{}, place, "names.file", file + ":" + std::to_string(line) + ":" + std::to_string(column)};
    const auto path = found[0] == "egg" ? std::optional(CellPath{}) : pathIn(found[0]);
    const std::string right = "needs a line 'PATH NAME', as 'AB ABp', or 'egg P0'";
    if (found.size() != 2)
      complain(use, found.size() == 1 ? "has a path and no name" : "has text after the name", right, reading.problems);
    else if (!path) complain(use, "'" + found[0] + "' is not a cell's path", right, reading.problems);
    else if (!isCellName(found[1]))
      complain(use, "'" + found[1] + "' is no name of a cell", std::string("needs ") + nameAllowed, reading.problems);
    else use.path = *path, nameCell(use, found[1], scenario, reading);
  }
  const bool isGood = reading.problems.size() == before;
  if (isGood && std::ranges::none_of(reading.names, [](const NameUse& u) { return !u.inFile.empty(); }))
    reading.problems.add(place, "names.file", "'" + file + "' names no cell", "needs lines 'PATH NAME'");
}

void checkCellNames(const Scenario& scenario, Reading& reading, const Node& root) {
  const CellNames& names = scenario.names;
  if (names.given.empty() && !names.daughters.empty() && reading.problems.empty())
    reading.problems.add(root.find("names")->place, "names.daughters", "has no cell's name to add to",
                         "name a cell that the others come from, as egg: P0");
  for (const NameUse& use : reading.names) {
    const std::string& name = names.given.at(use.path);
    for (const CellPath& other : names.find(name)) {
      const bool otherIsGiven = names.given.contains(other) && names.given.at(other) == name;
      if (other == use.path || (otherIsGiven && other < use.path)) continue;  // report each pair once
      complain(use, "'" + name + "' is also the name of " + words(other) + (otherIsGiven ? "" : ", by names.daughters"),
               "give each cell a name of her own", reading.problems);
    }
  }
}

}  // namespace morula::scenario
