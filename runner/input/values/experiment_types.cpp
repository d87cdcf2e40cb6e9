// The list `experiments`: what is done to which cells, and when. Entries are read once cells have their names and the
// DNA is known.
#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "files/text.h"
#include "values/cell_words.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

constexpr const char* form =
    "maps, as [{kill: ABp, at: 6.5}, {gene-off: g12, at-cells: 4}, {set: physics.drag, to: 5, at: 3}]";
const std::vector<std::string> whenKeys{"at", "after-birth", "at-cells"};

/// The keys of an entry besides its deed and its time.
std::vector<std::string> keysOf(Deed deed) {
  switch (deed) {
    case Deed::set: return {"to"};
    case Deed::cycles: return {"factor", "share"};
    case Deed::delay: return {"by", "share"};
    case Deed::kill: return {"share"};
    default: return {};
  }
}

bool takesCells(Deed deed) { return deed == Deed::kill || deed == Deed::cycles || deed == Deed::delay; }

/// Reads one entry; `path` is "experiments[2]".
class EntryReader {
 public:
  EntryReader(const Node& node, std::string path, const Scenario& scenario, Reading& reading)
      : node_(node), path_(std::move(path)), scenario_(scenario), reading_(reading) {}

  std::optional<Experiment> read() {
    std::vector<std::string> deeds;
    const Member* member = nullptr;
    for (const auto& row : choices<Deed>) {
      deeds.emplace_back(row.name);
      if (const Member* found = node_.find(row.name)) {
        if (member) say(found->place, found->key, "stands beside " + member->key, "write two entries");
        member = found, entry_.deed = row.value;
      }
    }
    if (!member) {
      std::string near;
      for (const Member& m : node_.members) near = near.empty() ? closest(m.key, deeds) : near;
      say(node_.place, "", "does not say what is done",
          near.empty() ? "needs one of " + join(deeds, " or ") : "did you mean " + near + "?");
      return {};
    }
    std::vector<std::string> known = keysOf(entry_.deed);
    known.push_back(member->key);
    known.insert(known.end(), whenKeys.begin(), whenKeys.end());
    refuseUnknown(node_, path_, known, reading_.problems);
    readWhat(*member);
    readNumbers();
    readWhen();
    return entry_;
  }

 private:
  void say(const Place& place, const std::string& key, const std::string& wrong, const std::string& right) {
    reading_.problems.add(place, key.empty() ? path_ : path_ + "." + key, wrong, right);
  }

  void addCells(const Node& node, const std::string& key) {
    const auto text = readText(node, path_ + "." + key, cellsAllowed, reading_.problems);
    if (!text) return;
    try {
      entry_.of.push_back(selectionOf(*text, scenario_.names, scenario_.scene.dna));
    } catch (const InputError& error) {
      const std::string what = error.what();
      const auto cut = what.find("; ");
      say(node.place, key, what.substr(0, cut),
          cut == what.npos ? std::string("needs ") + cellsAllowed : what.substr(cut + 2));
    }
  }

  void readWhat(const Member& member) {
    const std::string& key = member.key;
    const Node& node = member.value;
    if (takesCells(entry_.deed)) {
      if (node.kind != Node::Kind::sequence) {
        if (node.kind == Node::Kind::scalar && node.text == "all") return;  // without cells: all
        return addCells(node, key);
      }
      if (expectEntries(node, path_ + "." + key, "cells, or a list of several", reading_.problems))
        for (const Node& item : node.items) addCells(item, key);
    } else if (entry_.deed == Deed::connect || entry_.deed == Deed::release) {
      if (node.kind != Node::Kind::sequence || node.items.size() != 2)
        return say(member.place, key, "is not a pair of cells", "needs two cells, as [ABa, P2]");
      for (const Node& item : node.items) addCells(item, key);
      if (!scenario_.scene.mechanics || !scenario_.scene.mechanics->connections)
        say(member.place, key, "needs connections, and the scene has none", "add 'connections: {}'");
    } else if (const auto text = readText(node, path_ + "." + key, "a name", reading_.problems)) {
      entry_.name = *text;
      if (entry_.deed == Deed::set) checkParameter(member);
      else checkGene(member);
    }
  }

  void checkGene(const Member& member) {
    std::vector<std::string> names;
    for (const Gene& gene : scenario_.scene.dna.genes) names.push_back(gene.name);
    if (names.empty() || std::ranges::find(names, entry_.name) != names.end()) return;
    const std::string near = closest(entry_.name, names);
    say(member.place, member.key, "the DNA has no gene '" + entry_.name + "'",
        near.empty() ? "needs the name of a gene of the DNA" : "did you mean " + near + "?");
  }

  void checkParameter(const Member& member) {
    const std::string& name = entry_.name;
    std::vector<std::string> paths;
    for (const ChangeableParameter& p : changeableParameters) paths.emplace_back(p.path);
    if (!changeableParameter(name)) {
      const std::string near = closest(name, paths);
      return say(member.place, member.key, "'" + name + "' cannot change while a scene runs",
                 near.empty() ? "needs one of " + join(paths) : "did you mean " + near + "?");
    }
    auto mechanics = scenario_.scene.mechanics;
    ContactParameters* const contact = mechanics && mechanics->contact ? &*mechanics->contact : nullptr;
    const std::string other = name.ends_with(".ratio") ? name.substr(0, name.rfind('.')) : name + ".ratio";
    const ChangeableParameter* const instead = changeableParameter(other);
    const auto isThere = [&](const ChangeableParameter* row) {
      return mechanics && row->of(mechanics->physics, contact);
    };
    if (isThere(changeableParameter(name))) return;
    if (instead && isThere(instead))
      say(member.place, member.key,
          "'" + name + "' does not count in this scene, which gives this damping " +
              (name.ends_with(".ratio") ? "as a constant" : "as a share of critical"),
          "needs set: " + other);
    else
      say(member.place, member.key, "the scene has no " + name.substr(0, name.rfind('.')),
          "add that section, or remove this entry");
  }

  void readNumbers() {
    constexpr Range anyPositive{.low = 0, .openLow = true};
    const auto need = [&](const char* key, const Range& range, const char* unit, const char* example) {
      if (const auto value = readMember(node_, key, range, unit, path_, reading_.problems)) entry_.value = *value;
      else if (!node_.find(key)) say(node_.place, key, "is missing", std::string("needs a number, as ") + example);
    };
    if (entry_.deed == Deed::set) {
      const ChangeableParameter* const row = changeableParameter(entry_.name);
      need("to", {.low = 0, .openLow = row && !row->mayBeZero}, "", "to: 5");
    }
    if (entry_.deed == Deed::cycles) need("factor", anyPositive, "", "factor: 1.1");
    if (entry_.deed == Deed::delay) need("by", anyPositive, "time", "by: 0.5");
    if (takesCells(entry_.deed))
      entry_.share =
          readMember(node_, "share", {.low = 0, .high = 1, .openLow = true}, "", path_, reading_.problems).value_or(1);
  }

  void readWhen() {
    std::vector<const Member*> given;
    for (const std::string& key : whenKeys)
      if (const Member* member = node_.find(key)) given.push_back(member);
    if (given.empty())
      return say(node_.place, "", "does not say when", "needs one of at: TIME, after-birth: TIME or at-cells: N");
    if (given.size() > 1)
      return say(given[1]->place, given[1]->key, "stands beside " + given[0]->key,
                 "give one of " + join(whenKeys, " or "));
    const Member& when = *given[0];
    if (when.key == "at-cells") {
      entry_.atCells = readNatural(when.value, {1, 1'000'000'000}, path_ + ".at-cells", "a whole number from 1 on",
                                   reading_.problems);
      return;
    }
    const auto time = readMember(node_, when.key, {.low = 0}, "time", path_, reading_.problems);
    if (when.key == "after-birth" && !takesCells(entry_.deed))
      return say(when.place, when.key, "is no time of a deed that is done to all cells alike, or to a pair",
                 "needs at or at-cells");
    (when.key == "at" ? entry_.at : entry_.afterBirth) = time;
    const auto end = plannedEnd(scenario_.scene);
    if (time && when.key == "at" && end && *time > *end) {
      const Units& units = scenario_.units;
      const std::string shown =
          units.time.empty() ? "" : ", which is " + numberText(*end * units.perTime) + " " + units.time;
      say(when.place, when.key, "comes after the end of the run, " + numberText(*end) + shown,
          "give an earlier time, or a later stop.time");
    }
  }

  const Node& node_;
  std::string path_;
  const Scenario& scenario_;
  Reading& reading_;
  Experiment entry_;
};

Json cellsJson(const std::vector<CellSelection>& cells) {
  if (cells.empty()) return "all";
  Json list = Json::array();
  for (const CellSelection& one : cells) list.push_back(selectionText(one));
  return list;
}

Json writeEntry(const Experiment& e) {
  Json map;
  const bool ofName = e.deed == Deed::set || e.deed == Deed::geneOff || e.deed == Deed::geneOn;
  map[nameOf(e.deed)] = ofName ? Json(e.name) : cellsJson(e.of);
  if (e.deed == Deed::set) map["to"] = e.value;
  if (e.deed == Deed::cycles) map["factor"] = e.value;
  if (e.deed == Deed::delay) map["by"] = e.value;
  if (e.share != 1) map["share"] = e.share;
  if (e.at) map["at"] = *e.at;
  if (e.afterBirth) map["after-birth"] = *e.afterBirth;
  if (e.atCells) map["at-cells"] = *e.atCells;
  return map;
}

Json entrySchema() {
  const Json text{{"type", "string"}, {"minLength", 1}};
  const Json cells{{"oneOf", Json::array({text, {{"type", "array"}, {"items", text}, {"minItems", 1}}})}};
  const Json pair = listSchema(text, 2);
  Json properties{{"to", numberSchema({.low = 0})},
                  {"factor", numberSchema({.low = 0, .openLow = true})},
                  {"by", numberSchema({.low = 0, .openLow = true})},
                  {"share", numberSchema({.low = 0, .high = 1, .openLow = true})},
                  {"at", numberSchema({.low = 0})},
                  {"after-birth", numberSchema({.low = 0})},
                  {"at-cells", {{"type", "integer"}, {"minimum", 1}, {"maximum", 1'000'000'000}}}};
  Json deeds = Json::array();
  for (const auto& row : choices<Deed>) {
    const bool isPair = row.value == Deed::connect || row.value == Deed::release;
    properties[row.name] = isPair ? pair : takesCells(row.value) ? cells : text;
    deeds.push_back({{"required", Json::array({row.name})}});
  }
  Json whens = Json::array();
  for (const std::string& key : whenKeys) whens.push_back({{"required", Json::array({key})}});
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"allOf", Json::array({{{"oneOf", std::move(deeds)}}, {{"oneOf", std::move(whens)}}})},
          {"additionalProperties", false}};
}

}  // namespace

Parameter experiments() {
  Parameter p;
  p.path = "experiments";
  p.allowed = std::string("a list of ") + form;
  p.meaning =
      "Experiments on the organism while it grows, each at a time (at), a time after a cell's birth (after-birth), "
      "or a number of living cells (at-cells). ";
  for (const auto& row : choices<Deed>)
    p.meaning += std::string(row.name) + ": " + row.meaning + (row.value == Deed::release ? "" : "; ");
  p.absent = "no experiments";
  p.later = true;
  p.schema = {{"type", "array"}, {"items", entrySchema()}, {"minItems", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    if (expectEntries(node, path, allowed, reading.problems)) reading.experiments = node.items;
  };
  p.write = [](const Scenario& s) {
    if (s.scene.experiments.empty()) return Json();
    Json list = Json::array();
    for (const Experiment& e : s.scene.experiments) list.push_back(writeEntry(e));
    return list;
  };
  return p;
}

void readExperiments(Scenario& scenario, Reading& reading) {
  for (std::size_t i = 0; i < reading.experiments.size(); ++i) {
    const Node& item = reading.experiments[i];
    const std::string path = "experiments[" + std::to_string(i) + "]";
    if (item.kind == Node::Kind::broken) continue;
    if (item.kind != Node::Kind::map)
      reading.problems.add(item.place, path, "is " + describe(item), std::string("needs ") + form);
    else if (auto entry = EntryReader(item, path, scenario, reading).read())
      scenario.scene.experiments.push_back(std::move(*entry));
  }
}

}  // namespace morula::scenario
