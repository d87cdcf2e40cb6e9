// How cells divide: the plane, and the rules for some cells.
// Chirality is read here for rules; for all divisions it consists of two ordinary parameters.
#include <algorithm>

#include "base/did_you_mean.h"
#include "division/rules.h"
#include "values/cell_words.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

/// Joins choices: "a or b"; "a, b, or c".
std::string inWords(const std::vector<std::string>& choices) {
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
    text += (i == 0 ? "" : i + 1 < choices.size() ? ", " : i > 1 ? ", or " : " or ") + choices[i];
  return text;
}

std::string spell(const DivisionPlaneKind& kind) {
  if (kind.takes == Takes::nothing) return kind.name;
  return std::string("{") + kind.name + (kind.takes == Takes::substance ? ": a0}" : ": [x, y, z]}");
}

Json axisSchema() { return listSchema({{"type", "number"}}, 3); }

/// Returns the schema of an axis alone, or of one that turns.
Json polaritySchema() {
  const auto turning = [](const char* key) {
    return mapSchema({{"start", axisSchema()}, {key, {{"type", "string"}}}}, {"start", key});
  };
  return {{"oneOf", Json::array({axisSchema(), turning("turns-towards"), turning("turns-away-from")})}};
}

Json takenSchema(Takes takes) {
  return takes == Takes::axis ? axisSchema() : takes == Takes::substance ? Json{{"type", "string"}} : polaritySchema();
}

Json planeSchema() {
  Json words = Json::array(), forms = Json::array({nullptr});
  for (const DivisionPlaneKind& kind : divisionPlanes()) {
    if (kind.takes == Takes::nothing) words.push_back(kind.name);
    else forms.push_back(onlySchema(kind.name, takenSchema(kind.takes)));
  }
  forms[0] = {{"enum", words}};
  return {{"oneOf", forms}};
}

/// Reads {start: [x, y, z], turns-towards: a0}, or turns-away-from.
void readTurning(const Node& node, const std::string& path, Reading& reading, PlaneChoice& choice) {
  const std::string allowed = "start, and either turns-towards or turns-away-from with a substance";
  refuseUnknown(node, path, {"start", "turns-towards", "turns-away-from"}, reading.problems);
  const Member *start = nullptr, *turns = nullptr;
  for (const Member& member : node.members) {
    if (member.key == "start") start = &member;
    else if (turns && member.key.starts_with("turns-"))
      reading.problems.add(member.place, path + "." + member.key, "is one too many", "needs " + allowed);
    else if (member.key == "turns-towards" || member.key == "turns-away-from") turns = &member;
  }
  if (!start)
    reading.problems.add(node.place, path + ".start", "is missing", "needs the egg's polarity, as start: [1, 0, 0]");
  else if (const auto axis = readAxis(start->value, path + ".start", reading.problems)) choice.axis = *axis;
  if (!turns)
    return reading.problems.add(node.place, path, "turns nowhere",
                                "needs turns-towards or turns-away-from, or write polarity: [x, y, z]");
  choice.turnsAway = turns->key == "turns-away-from";
  if (const auto name = readPattern(turns->value, path + "." + turns->key, reading)) choice.substance = *name;
}

/// Reads the value behind the name of a plane that takes one.
std::optional<PlaneChoice> readTaken(const DivisionPlaneKind& kind, const Node& node, const std::string& path,
                                     Reading& reading) {
  PlaneChoice choice{.plane = kind.plane};
  if (kind.takes == Takes::polarity && node.kind == Node::Kind::map) {
    readTurning(node, path, reading, choice);
    return choice;
  }
  if (kind.takes != Takes::substance) {
    const auto axis = readAxis(node, path, reading.problems);
    if (!axis) return {};
    choice.axis = *axis;
    return choice;
  }
  const auto name = readPattern(node, path, reading);
  if (!name) return {};
  choice.substance = *name;
  return choice;
}

std::optional<PlaneChoice> readPlane(const Node& node, const std::string& path, Reading& reading) {
  const std::string allowed = planesAllowed();
  std::vector<std::string> words, keys;
  for (const DivisionPlaneKind& kind : divisionPlanes()) {
    (kind.takes == Takes::nothing ? words : keys).push_back(kind.name);
    if (kind.takes == Takes::nothing && node.kind == Node::Kind::scalar && node.text == kind.name)
      return PlaneChoice{.plane = kind.plane};
  }
  if (node.kind == Node::Kind::map) {
    const Member* taken = readOnly(node, path, keys, allowed, reading.problems);
    if (!taken) return {};
    const auto& kind = *std::ranges::find(divisionPlanes(), taken->key, &DivisionPlaneKind::name);
    return readTaken(kind, taken->value, path + "." + taken->key, reading);
  }
  if (node.kind == Node::Kind::broken) return {};
  const auto near = node.kind == Node::Kind::scalar ? closest(node.text, words) : "";
  reading.problems.add(node.place, path,
                       node.kind == Node::Kind::null     ? "is empty"
                       : node.kind == Node::Kind::scalar ? describe(node) + " is not known here"
                                                         : "is " + describe(node),
                       near.empty() ? "needs " + allowed : "did you mean " + near + "? Needs " + allowed);
  return {};
}

Json writePlane(const PlaneChoice& choice) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  if (kind.takes == Takes::nothing) return Json(kind.name);
  if (kind.takes == Takes::substance) return Json{{kind.name, choice.substance}};
  const Json axis{choice.axis.x, choice.axis.y, choice.axis.z};
  if (choice.substance.empty()) return Json{{kind.name, axis}};
  const char* turns = choice.turnsAway ? "turns-away-from" : "turns-towards";
  return Json{{kind.name, {{"start", axis}, {turns, choice.substance}}}};
}

const std::vector<std::string> ruleKeys{"of", "axis", "plane", "share", "tilt", "chirality"};
constexpr Range shareRange{.low = minShare, .high = largestShare}, tiltRange{.low = 0, .high = 90};
constexpr const char* ruleForm = "a map, as {of: AB, axis: [1, 0, 0], share: 0.6, tilt: 10}";

/// Reads one rule; `path` is "division.rules[2]".
class RuleReader {
 public:
  RuleReader(const Node& node, std::string path, Reading& reading)
      : node_(node), path_(std::move(path)), reading_(reading) {}

  DivisionRule read() {
    DivisionRule rule;
    refuseUnknown(node_, path_, ruleKeys, reading_.problems);
    readCells(rule);
    readDirection(rule);
    rule.share = readMember(node_, "share", shareRange, "", path_, reading_.problems);
    rule.tilt = readMember(node_, "tilt", tiltRange, "degree", path_, reading_.problems);
    if (const auto* chirality = node_.find("chirality"))
      rule.chirality = readChirality(chirality->value, path_ + ".chirality", reading_.problems);
    const auto saysSomething = [](const Member& m) { return m.key != "of"; };
    if (node_.find("of") && std::ranges::none_of(node_.members, saysSomething))
      reading_.problems.add(node_.place, path_, "does not say how these cells divide",
                            "needs at least one of axis, plane, share, tilt, chirality");
    return rule;
  }

 private:
  void readCells(DivisionRule& rule) {
    const std::string path = path_ + ".of";
    const auto* of = node_.find("of");
    if (!of) {
      reading_.problems.add(node_.place, path, "is missing",
                            "needs a substance of the rule's cells, 'cell NAME', or a list of several, as of: AB");
      return;
    }
    if (of->value.kind != Node::Kind::sequence) {
      if (callsCells(of->value)) return waitForNames(of->value, path);
      if (const auto pattern = readPattern(of->value, path, reading_)) rule.of.push_back(*pattern);
      return;
    }
    if (!expectEntries(of->value, path, "a substance, or a list of several", reading_.problems)) return;
    for (const Node& item : of->value.items) {
      if (callsCells(item)) {
        waitForNames(item, path);
        continue;
      }
      const auto pattern = readPattern(item, path, reading_);
      if (!pattern) continue;
      if (std::ranges::find(rule.of, *pattern) != rule.of.end())
        reading_.problems.add(item.place, path, "'" + *pattern + "' is given twice", "keep one");
      rule.of.push_back(*pattern);
    }
  }

  /// Returns true for "cell EMS", which a substance cannot be called.
  static bool callsCells(const Node& node) {
    return node.kind == Node::Kind::scalar && node.text.find(' ') != node.text.npos;
  }

  void waitForNames(const Node& node, const std::string& path) {
    reading_.ruleCells.push_back({reading_.rules.size(), node.text, node.place, path});
  }

  /// Reads the plane; `axis: v` is short for `plane: {axis: v}`.
  void readDirection(DivisionRule& rule) {
    const auto *axis = node_.find("axis"), *plane = node_.find("plane");
    if (axis && plane)
      reading_.problems.add(axis->place, path_ + ".axis", "stands beside plane", "give one of axis or plane");
    if (plane) rule.plane = readPlane(plane->value, path_ + ".plane", reading_);
    else if (axis)
      if (const auto direction = readAxis(axis->value, path_ + ".axis", reading_.problems))
        rule.plane = PlaneChoice{.plane = DivisionPlane::axis, .axis = *direction};
  }

  const Node& node_;
  std::string path_;
  Reading& reading_;
};

Json ruleSchema() {
  const Json pattern{
      {"type", "string"}, {"pattern", "^([^* ]*[*]?|(cell|clone|path|generation|substance) [^ ]+)$"}, {"minLength", 1}};
  Json properties{
      {"of",
       {{"oneOf",
         Json::array({pattern, {{"type", "array"}, {"items", pattern}, {"minItems", 1}, {"uniqueItems", true}}})}}},
      {"axis", axisSchema()},
      {"plane", planeSchema()},
      {"share", numberSchema(shareRange)},
      {"tilt", numberSchema(tiltRange)},
      {"chirality", chiralitySchema()}};
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", Json::array({"of"})},
          {"minProperties", 2},
          {"not", {{"required", Json::array({"axis", "plane"})}}},
          {"additionalProperties", false}};
}

Json writeRule(const DivisionRule& rule) {
  Json map{{"of", rule.of}};
  for (const CellSelection& cells : rule.cells) map["of"].push_back(selectionText(cells));
  if (rule.plane) map["plane"] = writePlane(*rule.plane);
  if (rule.share) map["share"] = *rule.share;
  if (rule.tilt) map["tilt"] = *rule.tilt;
  if (rule.chirality) map["chirality"] = writeChirality(*rule.chirality);
  return map;
}

}  // namespace

std::string planesAllowed(bool ofSpheres) {
  std::vector<std::string> allowed;
  for (const DivisionPlaneKind& kind : divisionPlanes())
    if (!(ofSpheres && kind.needsShape)) allowed.push_back(spell(kind));
  return inWords(allowed);
}

Parameter divisionPlane() {
  Parameter p;
  p.path = "division.plane";
  p.allowed = planesAllowed();
  std::vector<std::string> meanings;
  for (const DivisionPlaneKind& kind : divisionPlanes())
    meanings.push_back(std::string(kind.name) + ": " + kind.meaning);
  p.meaning = "Cells divide across an axis. ";
  for (const std::string& one : meanings) p.meaning += one + (&one == &meanings.back() ? "" : "; ");
  p.schema = planeSchema();
  p.read = [path = p.path](Scenario& s, const Node& node, Reading& reading) {
    if (const auto choice = readPlane(node, path, reading)) s.scene.mechanics->division.otherwise = *choice;
  };
  p.write = [](const Scenario& s) { return writePlane(s.scene.mechanics->division.otherwise); };
  return p;
}

Parameter divisionRules() {
  Parameter p;
  p.path = "division.rules";
  p.allowed = "a list of maps, as [{of: AB, axis: [1, 0, 0], share: 0.6, tilt: 10}, {of: [skin, 'P*'], plane: random}]";
  p.meaning =
      "Rules for the divisions of some cells; the first rule counts whose substances in `of` (a name, its beginning "
      "and '*', or a list) a cell holds all. Keys: axis, which points to daughter A, or plane, as division.plane; "
      "share of the volume for A, 0.1 to 0.9, instead of a plane through the centre; tilt, the standard deviation "
      "in degrees of the axis about its direction, by the seed; chirality, as division.chirality";
  p.absent = "all cells divide by division.plane";
  p.schema = {{"type", "array"}, {"items", ruleSchema()}, {"minItems", 1}};
  p.read = [path = p.path, allowed = p.allowed](Scenario& s, const Node& node, Reading& reading) {
    if (!expectEntries(node, path, allowed, reading.problems)) return;
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Node& item = node.items[i];
      const std::string at = path + "[" + std::to_string(i) + "]";
      if (item.kind == Node::Kind::map) {
        s.scene.mechanics->division.rules.push_back(RuleReader(item, at, reading).read());
        reading.rules.push_back(item.place);
      } else if (item.kind != Node::Kind::broken) {
        reading.problems.add(item.place, at, "is " + describe(item), std::string("needs ") + ruleForm);
      }
    }
  };
  p.write = [](const Scenario& s) {
    const auto& rules = s.scene.mechanics->division.rules;
    if (rules.empty()) return Json();
    Json list = Json::array();
    for (const DivisionRule& rule : rules) list.push_back(writeRule(rule));
    return list;
  };
  return p;
}

std::optional<Chirality> readChirality(const Node& node, const std::string& path, Problems& problems) {
  if (node.kind != Node::Kind::map) {
    refuse(node, path, "{angle: 20, time: 0.5}", problems);
    return {};
  }
  refuseUnknown(node, path, {"angle", "time"}, problems);
  const Chirality usual;
  return Chirality{readMember(node, "angle", chiralAngle, "degree", path, problems).value_or(usual.angle),
                   readMember(node, "time", positive, "time", path, problems).value_or(usual.time)};
}

Json writeChirality(const Chirality& c) { return {{"angle", c.angle}, {"time", c.time}}; }

Json chiralitySchema() {
  return mapSchema({{"angle", numberSchema(chiralAngle)}, {"time", numberSchema(positive)}}, {});
}

void readRuleCells(Scenario& scenario, Reading& reading) {
  if (!scenario.scene.mechanics) return;
  std::vector<DivisionRule>& rules = scenario.scene.mechanics->division.rules;
  for (const RuleCells& cells : reading.ruleCells) try {
      const CellSelection selection = selectionOf(cells.text, scenario.names, scenario.scene.dna);
      if (cells.rule >= rules.size()) continue;  // an unreadable rule has been reported
      if (selection.kind == CellSelection::Kind::substance) rules[cells.rule].of.push_back(selection.substance);
      else rules[cells.rule].cells.push_back(selection);
    } catch (const InputError& error) { addReadError(cells.place, cells.path, error, reading.problems); }
}

}  // namespace morula::scenario
