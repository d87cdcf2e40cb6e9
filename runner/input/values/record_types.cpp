// Keys of `record` besides regular samples: samples at numbers of cells, and measures on demand.
#include <algorithm>

#include "values/cell_words.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

std::vector<AskedMeasure> onDemand() {
  std::vector<AskedMeasure> all = allMeasures();
  std::erase_if(all, [](const AskedMeasure& m) { return !m.onDemand; });
  return all;
}

}  // namespace

Json measuresSchema(const std::vector<AskedMeasure>& known) {
  Json names = Json::array();
  for (const AskedMeasure& m : known) {
    names.push_back(m.name);
    std::string dashed = m.name;
    std::ranges::replace(dashed, '_', '-');
    if (dashed != m.name) names.push_back(dashed);
  }
  const Json ofSome{{"type", "string"}, {"pattern", "^([a-z][a-z._-]* of .+|distance .+ .+|.+ [/-] .+)$"}};
  const Json items{{"anyOf", Json::array({Json{{"enum", names}}, ofSome})}};
  return {{"type", "array"}, {"items", items}, {"minItems", 1}, {"uniqueItems", true}};
}

void addReadError(const Place& place, const std::string& path, const InputError& error, Problems& problems) {
  const std::string what = error.what();  // "what is wrong; the remedy"
  const auto end = what.rfind("; ");
  problems.add(place, path, what.substr(0, end), what.substr(end + 2));
}

Parameter recordAtCells() {
  Parameter p;
  p.path = "record.at-cells";
  p.allowed = "rising whole numbers, as [4, 8, 28]";
  p.meaning =
      "Numbers of living cells at which a sample is taken, too, and with pictures a picture of the "
      "sequence, when each is first reached";
  p.absent = "at no number of cells";
  p.later = true;
  p.schema = {
      {"type", "array"}, {"items", {{"type", "integer"}, {"minimum", 1}, {"maximum", 1'000'000'000}}}, {"minItems", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (!expectEntries(node, path, allowed, reading.problems)) return;
    auto& numbers = s.record.atCells;
    for (const Node& item : node.items) {
      const auto number = readNatural(item, {1, 1'000'000'000}, path, allowed, reading.problems);
      if (!number) continue;
      if (!numbers.empty() && *number <= numbers.back())
        reading.problems.add(item.place, path,
                             std::to_string(*number) + " comes behind " + std::to_string(numbers.back()),
                             "needs " + allowed);
      else numbers.push_back(*number);
    }
  };
  p.write = [](const Scenario& s) { return s.record.atCells.empty() ? Json() : Json(s.record.atCells); };
  return p;
}

Parameter recordMeasures() {
  Parameter p;
  p.path = "record.measures";
  p.allowed = "a list of measures on demand, as [sister_contact, shell_share of AAA*]";
  p.meaning =
      "Measures that each sample takes in addition, into table measure: those on demand of scenarios/MEASURES.md, "
      "measures of some cells (count of skin), distances (distance cell ABa cell P2), ratios (a / b) and differences "
      "(a - b)";
  p.absent = "none";
  p.later = true;
  p.schema = measuresSchema(onDemand());
  p.read = [path = p.path, allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    if (!expectEntries(node, path, allowed, reading.problems)) return;
    reading.measures = node.items;
    for (const Node& item : node.items)
      if (const auto m = findMeasure(item.text))
        for (const AskedMeasure& term : m->terms())
          for (const auto& cells : {term.of, term.to})
            if (cells && cells->kind == CellSelection::Kind::substance) reading.measured.push_back(cells->substance);
  };
  p.write = [](const Scenario& s) { return s.record.measures.empty() ? Json() : Json(s.record.measures); };
  return p;
}

void readRecordMeasures(Scenario& scenario, Reading& reading) {
  const std::string path = "record.measures";
  std::vector<std::string>& measures = scenario.record.measures;
  for (const Node& item : reading.measures) {
    const auto text = readText(item, path, "a measure's name", reading.problems);
    if (!text) continue;
    try {
      const AskedMeasure m = resolved(readMeasure(*text, IfSeveral::first), scenario.names, scenario.scene.dna);
      if (!m.onDemand)
        reading.problems.add(item.place, path, "'" + *text + "' is part of every sample already", "remove it");
      else if (std::ranges::find(measures, m.name) != measures.end())
        reading.problems.add(item.place, path, "'" + *text + "' is given twice", "remove it");
      else measures.push_back(m.name);
      for (const AskedMeasure& term : m.terms())
        for (const auto& cells : {term.of, term.to})
          if (cells && cells->kind == CellSelection::Kind::substance)
            reading.substances.push_back({cells->substance, item.place, path, cells->substance.ends_with('*')});
    } catch (const InputError& error) { addReadError(item.place, path, error, reading.problems); }
  }
}

}  // namespace morula::scenario
