// Maps from substances to values.
#include "base/error.h"
#include "values/cell_words.h"
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

/// Reads '#rrggbb' in lower case; absent after a mistake, which is reported.
std::optional<std::string> readColour(const Node& node, const std::string& path, Problems& problems) {
  const std::string form = "a colour '#rrggbb', in quotes because '#' begins a comment";
  auto colour = readText(node, path, form, problems);
  if (!colour) return {};
  bool good = colour->size() == 7 && colour->front() == '#';
  for (auto& c : *colour) {
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
    good = good && (&c == &colour->front() || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'));
  }
  if (good) return colour;
  problems.add(node.place, path, describe(node) + " is not a colour", "needs " + form);
  return {};
}

Parameter colours() {
  Parameter p;
  p.path = "colours";
  p.allowed = std::string("a map of substances, beginnings of names and '*', or cells (cell NAME, clone NAME, path ") +
              "AAB, path AAB*, generation N) to colours '#rrggbb'";
  p.meaning =
      "Colours of cells. A cell mixes those of its substances; longer patterns win. A colour of a cell, a clone or a "
      "generation takes their place: that of the cell itself, else of the smallest clone, else of the generation";
  p.decides = Decides::presentation;
  p.schema = {{"type", "object"}, {"additionalProperties", {{"type", "string"}, {"pattern", "^#[0-9A-Fa-f]{6}$"}}}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (node.kind != Node::Kind::map) return refuse(node, path, allowed, reading.problems);
    for (const auto& member : node.members) {
      if (member.key.empty()) continue;
      const std::string at = path + "." + member.key;
      const auto colour = readColour(member.value, at, reading.problems);
      const bool callsCells = member.key.find(' ') != member.key.npos;
      if (!callsCells) reading.substances.push_back({member.key, member.place, at, member.key.ends_with('*')});
      if (colour && callsCells) reading.cellColours.push_back({member.key, *colour, member.place, at});
      else if (colour) s.colours[member.key] = *colour;
    }
  };
  p.write = [](const Scenario& s) {
    Json map(s.colours);
    for (const CellColour& one : s.cellColours) map[one.text] = one.colour;
    return map;
  };
  return p;
}

void readCellColours(Scenario& scenario, Reading& reading) {
  for (const WrittenColour& written : reading.cellColours) try {
      const CellSelection cells = selectionOf(written.cells, scenario.names, scenario.scene.dna);
      if (cells.kind == CellSelection::Kind::substance) scenario.colours[cells.substance] = written.colour;
      else scenario.cellColours.push_back({cells, written.cells, written.colour});
    } catch (const InputError& error) { addReadError(written.place, written.path, error, reading.problems); }
}

}  // namespace morula::scenario
