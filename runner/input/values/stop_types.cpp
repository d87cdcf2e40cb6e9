// The list `stop.when`: conditions that end a run. Entries are read once cells have their names and the DNA is known.
#include <algorithm>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "base/number_text.h"
#include "files/text.h"
#include "physics/integrator.h"
#include "values/cell_words.h"
#include "values/measure_list.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

constexpr const char* whenForm = "maps, as [{touch: [cell ABa, cell P2]}, {cells: 4, of: skin}, {born: cell MS}]";

std::vector<std::string> whenKeysOf(StopEvent event) {
  switch (event) {
    case StopEvent::cells: return {"of", "after"};
    case StopEvent::measure: return {"above", "below", "after"};
    default: return {"after"};
  }
}

/// Reads one entry; `path` is "stop.when[2]".
class WhenReader {
 public:
  WhenReader(const Node& node, std::string path, const Scenario& scenario, Reading& reading)
      : node_(node), path_(std::move(path)), scenario_(scenario), reading_(reading) {}

  std::optional<StopWhen> read() {
    const Member* what = nullptr;
    std::vector<std::string> events;
    for (const auto& row : choices<StopEvent>) {
      events.emplace_back(row.name);
      const Member* member = node_.find(row.name);
      if (!member) continue;
      if (what) return say(member->place, member->key, "stands beside " + what->key, "give each an entry of its own");
      what = member, entry_.event = row.value;
    }
    if (!what) return say(node_.place, "", "says no condition", "needs one of " + join(events, " or "));
    std::vector<std::string> keys = whenKeysOf(entry_.event);
    keys.push_back(what->key);
    refuseUnknown(node_, path_, keys, reading_.problems);
    entry_.after = readMember(node_, "after", {.low = 0}, "time", path_, reading_.problems).value_or(0);
    const std::size_t before = reading_.problems.size();
    readWhat(*what);
    return reading_.problems.size() == before ? std::optional(entry_) : std::nullopt;
  }

 private:
  std::nullopt_t say(const Place& place, const std::string& key, const std::string& wrong, const std::string& right) {
    reading_.problems.add(place, key.empty() ? path_ : path_ + "." + key, wrong, right);
    return std::nullopt;
  }

  void readWhat(const Member& what) {
    const Node& node = what.value;
    if (entry_.event == StopEvent::touch || entry_.event == StopEvent::part) {
      if (node.kind != Node::Kind::sequence || node.items.size() != 2) {
        say(what.place, what.key, "is no pair of cells", "needs two, as [cell ABa, cell P2]");
        return;
      }
      for (const Node& item : node.items) addCells(item, what.key);
      if (!scenario_.scene.mechanics || !scenario_.scene.mechanics->contact)
        say(what.place, what.key, "needs cells that can touch", "add 'contact: {}' to physics");
    } else if (entry_.event == StopEvent::born) {
      addCells(node, what.key);
    } else if (entry_.event == StopEvent::cells) {
      const auto count =
          readNatural(node, {1, 1'000'000'000}, path_ + ".cells", "a whole number from 1 on", reading_.problems);
      entry_.count = static_cast<double>(count.value_or(1));
      if (const Member* of = node_.find("of")) addCells(of->value, "of");
    } else if (entry_.event == StopEvent::rest) {
      entry_.below =
          readReal(node, positive, path_ + ".rest", numberAllowed(positive, "length/time"), reading_.problems);
      const auto& mechanics = scenario_.scene.mechanics;
      if (!mechanics) say(what.place, what.key, "needs cells with bodies", "add a physics block");
      else if (kindOf(mechanics->physics.integrator).settles)
        say(what.place, what.key, "holds after every event, because cells settle", "needs another condition");
    } else {
      readMeasureOf(what);
    }
  }

  void readMeasureOf(const Member& what) {
    const auto text = readText(what.value, path_ + ".measure", "a measure", reading_.problems);
    if (!text) return;
    try {
      const AskedMeasure asked = resolved(readMeasure(*text), scenario_.names, scenario_.scene.dna);
      entry_.measure = asked.name;
      for (const AskedMeasure& term : asked.terms())
        if (term.needs == Needs::referenceContacts || term.needs == Needs::referencePositions ||
            term.row == "contact_duration")
          say(what.place, what.key, term.name + " is known after a run alone", "needs another measure");
        else if (const std::string lacking = lackingFor(term.needs, scenario_); !lacking.empty())
          say(what.place, what.key, term.name + " would find nothing to measure", "needs " + lacking);
      const std::string unknown = unknownSubstance(asked, scenario_.scene.dna.substances);
      if (!unknown.empty()) addReadError(what.place, path_ + ".measure", InputError(unknown), reading_.problems);
    } catch (const InputError& error) { addReadError(what.place, path_ + ".measure", error, reading_.problems); }
    entry_.above = readMember(node_, "above", {}, "", path_, reading_.problems);
    entry_.below = readMember(node_, "below", {}, "", path_, reading_.problems);
    if (!entry_.above && !entry_.below)
      say(what.place, what.key, "has no bound", "needs above: NUMBER, below: NUMBER, or both");
  }

  void addCells(const Node& node, const std::string& key) {
    const auto text = readText(node, path_ + "." + key, cellsAllowed, reading_.problems);
    if (!text) return;
    try {
      entry_.of.push_back(selectionOf(*text, scenario_.names, scenario_.scene.dna));
    } catch (const InputError& error) { addReadError(node.place, path_ + "." + key, error, reading_.problems); }
  }

  const Node& node_;
  std::string path_;
  const Scenario& scenario_;
  Reading& reading_;
  StopWhen entry_;
};

Json writeWhen(const StopWhen& when) {
  Json cells = Json::array();
  for (const CellSelection& one : when.of) cells.push_back(selectionText(one));
  Json map;
  const char* const key = nameOf(when.event);
  if (when.event == StopEvent::cells) {
    map[key] = static_cast<std::uint64_t>(when.count);
    if (!when.of.empty()) map["of"] = cells[0];
  } else if (when.event == StopEvent::measure) {
    map[key] = when.measure;
    if (when.above) map["above"] = *when.above;
    if (when.below) map["below"] = *when.below;
  } else if (when.event == StopEvent::rest) {
    map[key] = *when.below;
  } else {
    map[key] = when.event == StopEvent::born ? cells[0] : cells;
  }
  if (when.after > 0) map["after"] = when.after;
  return map;
}

Json whenSchema() {
  const Json text{{"type", "string"}, {"minLength", 1}}, pair = listSchema(text, 2);
  Json events = Json::array();
  for (const auto& row : choices<StopEvent>) events.push_back({{"required", Json::array({row.name})}});
  return {{"type", "object"},
          {"properties",
           {{"touch", pair},
            {"part", pair},
            {"born", text},
            {"cells", {{"type", "integer"}, {"minimum", 1}, {"maximum", 1'000'000'000}}},
            {"of", text},
            {"measure", text},
            {"rest", numberSchema(positive)},
            {"above", numberSchema({})},
            {"below", numberSchema({})},
            {"after", numberSchema({.low = 0})}}},
          {"oneOf", std::move(events)},
          {"additionalProperties", false}};
}

}  // namespace

Parameter stopWhen() {
  Parameter p;
  p.path = "stop.when";
  p.allowed = std::string("a list of ") + whenForm;
  p.meaning = "As soon as one of these conditions holds, seen after cell cycles and each stop.every. ";
  for (const auto& row : choices<StopEvent>) p.meaning += std::string(row.name) + ": " + row.meaning + "; ";
  p.meaning += "after: a time before which a condition does not count";
  p.absent = "no condition";
  p.later = true;
  p.schema = {{"type", "array"}, {"items", whenSchema()}, {"minItems", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario&, const Node& node, Reading& reading) {
    if (expectEntries(node, path, allowed, reading.problems)) reading.stopWhen = node.items;
  };
  p.write = [](const Scenario& s) {
    if (s.scene.stop.when.empty()) return Json();
    Json list = Json::array();
    for (const StopWhen& when : s.scene.stop.when) list.push_back(writeWhen(when));
    return list;
  };
  return p;
}

void readStopWhen(Scenario& scenario, Reading& reading) {
  for (std::size_t i = 0; i < reading.stopWhen.size(); ++i) {
    const Node& item = reading.stopWhen[i];
    const std::string path = "stop.when[" + std::to_string(i) + "]";
    if (item.kind == Node::Kind::map) {
      if (auto entry = WhenReader(item, path, scenario, reading).read())
        scenario.scene.stop.when.push_back(std::move(*entry));
    } else if (item.kind != Node::Kind::broken) {
      reading.problems.add(item.place, path, "is " + describe(item), "needs a map, as {touch: [cell ABa, cell P2]}");
    }
  }
}

std::string stopText(const StopWhen& when, const CellNames& names) {
  const auto called = [&](const CellSelection& cells) {
    const bool isOne = cells.kind == CellSelection::Kind::cell;
    const auto name = isOne || cells.kind == CellSelection::Kind::clone ? names.of(cells.path) : std::nullopt;
    return name ? (isOne ? "cell " : "clone ") + *name : selectionText(cells);
  };
  std::string text = nameOf(when.event) + std::string(": ");
  if (when.event == StopEvent::cells)
    text += exactText(when.count) + (when.of.empty() ? "" : ", of: " + called(when.of[0]));
  else if (when.event == StopEvent::measure)
    text += when.measure + (when.above ? ", above: " + exactText(*when.above) : "") +
            (when.below ? ", below: " + exactText(*when.below) : "");
  else if (when.event == StopEvent::rest) text += exactText(*when.below);
  else if (when.event == StopEvent::born) text += called(when.of[0]);
  else text += "[" + called(when.of[0]) + ", " + called(when.of[1]) + "]";
  return "{" + text + "}";
}

}  // namespace morula::scenario
