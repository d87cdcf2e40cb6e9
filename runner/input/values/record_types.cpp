// What is recorded besides samples at regular times: at numbers of cells, and measures on demand.
#include <algorithm>

#include "base/did_you_mean.h"
#include "files/text.h"
#include "simulation/measures.h"
#include "values/value_types.h"

namespace morula::scenario {

namespace {

std::vector<std::string> namesOnDemand() {
  std::vector<std::string> names;
  for (const MeasureOnDemand& m : measuresOnDemand()) names.push_back(m.name);
  return names;
}

template <class Of>
bool isSampled(const std::string& name) {
  return std::ranges::any_of(sampledMeasures<Of>(), [&](const Measure<Of>& m) { return m.name == name; });
}

/// What is wrong with a name that no measure on demand has.
std::pair<std::string, std::string> complaintAbout(const std::string& name) {
  if (isSampled<Observation>(name) || isSampled<CellContext>(name) || isSampled<Touch>(name))
    return {"'" + name + "' is taken at every sample without being asked", "remove it"};
  const auto known = namesOnDemand();
  const std::string near = closest(name, known);
  return {"there is no measure '" + name + "'",
          near.empty() ? "needs some of " + join(known) : "did you mean " + near + "?"};
}

}  // namespace

Parameter recordAtCells() {
  Parameter p;
  p.path = "record.at-cells";
  p.allowed = "rising whole numbers, as [4, 8, 28]";
  p.meaning =
      "Also a sample, and with pictures a picture of the sequence, when so many cells live for the first "
      "time";
  p.absent = "at no number of cells";
  p.later = true;
  p.schema = {{"type", "array"},
              {"items", {{"type", "integer"}, {"minimum", 1}, {"maximum", 1'000'000'000}}},
              {"minItems", 1}};
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
  p.allowed = "a list of measures on demand, as [sister_contact, clone_radius]";
  p.meaning = "Also taken at every sample, into table measure: those on demand of scenarios/MEASURES.md";
  p.absent = "none";
  p.later = true;
  p.schema = {
      {"type", "array"}, {"items", {{"enum", namesOnDemand()}}}, {"minItems", 1}, {"uniqueItems", true}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (!expectEntries(node, path, allowed, reading.problems)) return;
    const auto known = namesOnDemand();
    for (const Node& item : node.items) {
      const auto name = readText(item, path, "a measure's name", reading.problems);
      if (!name) continue;
      if (std::ranges::find(known, *name) == known.end()) {
        const auto [wrong, right] = complaintAbout(*name);
        reading.problems.add(item.place, path, wrong, right);
      } else if (std::ranges::find(s.record.measures, *name) != s.record.measures.end()) {
        reading.problems.add(item.place, path, "'" + *name + "' stands there twice", "remove it");
      } else {
        s.record.measures.push_back(*name);
      }
    }
  };
  p.write = [](const Scenario& s) { return s.record.measures.empty() ? Json() : Json(s.record.measures); };
  return p;
}

}  // namespace morula::scenario
