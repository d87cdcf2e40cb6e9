// The section `senses`: for each substance one condition, of a kind that a row of biology/sense.h describes.
#include <algorithm>

#include "biology/sense.h"
#include "biology/substances.h"
#include "files/text.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

constexpr const char* senseForm = "one condition, as {neighbours: {at-least: 6}} or {contact: {of: a5}}";

struct Bound {
  const char* key;
  std::optional<double> Threshold::*value;
};
constexpr Bound bounds[] = {{"below", &Threshold::below},
                            {"above", &Threshold::above},
                            {"at-most", &Threshold::atMost},
                            {"at-least", &Threshold::atLeast},
                            {"until", &Threshold::until}};

std::vector<std::string> namesOfKinds() {
  std::vector<std::string> names;
  for (const SenseKindRow* row : senseKinds()) names.push_back(row->name);
  return names;
}

std::vector<std::string> keysOf(const SenseKindRow& row) {
  std::vector<std::string> keys;
  if (row.of.key) keys.push_back(row.of.key);
  if (row.takesLives) keys.push_back("lives");
  if (row.number.key) keys.push_back(row.number.key);
  if (row.takesAxis) keys.push_back("axis");
  if (!row.threshold)
    for (const Bound& bound : bounds) keys.push_back(bound.key);
  return keys;
}

/// Reads {kind: {keys …}}; `path` is "senses.touched".
class SenseReader {
 public:
  SenseReader(std::string path, Reading& reading) : path_(std::move(path)), reading_(reading) {}

  std::optional<SenseParameters> read(const Member& member) {
    if (member.value.kind != Node::Kind::map) {
      refuse(member.value, path_, senseForm, problems());
      return {};
    }
    const Member* given = readOnly(member.value, path_, namesOfKinds(), senseForm, problems());
    if (!given) return {};
    const auto row = std::ranges::find(senseKinds(), given->key, [](const SenseKindRow* r) { return r->name; });
    sense_.substance = member.key;
    sense_.kind = (*row)->kind;
    path_ += "." + given->key;
    if (given->value.kind != Node::Kind::map) {
      refuse(given->value, path_, "a map with " + join(keysOf(**row)), problems());
      return {};
    }
    readKeys(**row, given->value);
    return sense_;
  }

 private:
  Problems& problems() { return reading_.problems; }

  void readKeys(const SenseKindRow& row, const Node& node) {
    refuseUnknown(node, path_, keysOf(row), problems());
    readOf(row, node);
    if (row.number.key) readNumber(row, node);
    if (const Member* member = row.takesAxis ? require(node, "axis", "a direction, as [1, 0, 0]") : nullptr)
      if (const auto axis = readAxis(member->value, path_ + ".axis", problems())) sense_.axis = *axis;
    if (!row.threshold) readThreshold(row, node);
  }

  const Member* require(const Node& node, const std::string& key, const std::string& right) {
    const Member* member = node.find(key);
    if (!member) problems().add(node.place, path_ + "." + key, "is missing", "needs " + right);
    return member;
  }

  void readOf(const SenseKindRow& row, const Node& node) {
    const Member* lives = row.takesLives ? node.find("lives") : nullptr;
    if (lives) readLives(lives->value);
    if (!row.of.key) return;
    const Member* of = node.find(row.of.key);
    const std::string right = "a substance, or the beginning of a name and '*'", key = row.of.key;
    if (!of) {
      if (row.of.required || (row.takesLives && !lives)) require(node, key, right);
      return;
    }
    if (lives) problems().add(of->place, path_ + "." + key, "stands beside lives", "give " + key + " or lives");
    if (const auto name = readPattern(of->value, path_ + "." + key, reading_)) sense_.of = *name;
  }

  void readLives(const Node& node) {
    const auto value = readText(node, path_ + ".lives", "true or false", problems());
    if (value && *value != "true" && *value != "false")
      problems().add(node.place, path_ + ".lives", "is " + describe(node), "needs true or false");
    sense_.lives = value != "false";
  }

  void readNumber(const SenseKindRow& row, const Node& node) {
    const std::string allowed = numberAllowed(positive, row.number.unit);
    const Member* member = row.number.required ? require(node, row.number.key, allowed) : node.find(row.number.key);
    if (!member) return;
    sense_.number = readReal(member->value, positive, path_ + "." + row.number.key, allowed, problems());
  }

  void readThreshold(const SenseKindRow& row, const Node& node) {
    bool good = true;
    for (const Bound& bound : bounds) {
      sense_.is.*bound.value = readMember(node, bound.key, {}, row.unit, path_, problems());
      good = good && (sense_.is.*bound.value || !node.find(bound.key));
    }
    if (good) checkThreshold(row, node);
  }

  static bool hasUnknown(const SenseKindRow& row, const Node& node) {
    const auto known = keysOf(row);
    return std::ranges::any_of(
        node.members, [&](const Member& member) { return std::ranges::find(known, member.key) == known.end(); });
  }

  void checkThreshold(const SenseKindRow& row, const Node& node) {
    const auto& [below, above, atMost, atLeast, until] = sense_.is;
    const auto complain = [&](const std::string& wrong, const std::string& right) {
      problems().add(node.place, path_, wrong, right);
    };
    if (!below && !above && !atMost && !atLeast && hasUnknown(row, node)) return;  // perhaps a misspelt bound
    if (!below && !above && !atMost && !atLeast)
      return complain("has no bounds for its number", "needs below, above, at-most or at-least");
    if (below && atMost) return complain("has two upper bounds", "give below or at-most");
    if (above && atLeast) return complain("has two lower bounds", "give above or at-least");
    const bool hasUpper = below || atMost, hasLower = above || atLeast;
    const double upper = below ? *below : atMost.value_or(0), lower = above ? *above : atLeast.value_or(0);
    if (hasUpper && hasLower && (upper < lower || (upper == lower && (below || above))))
      return complain("no number is above " + exactText(lower) + " and below " + exactText(upper),
                      "give a lower bound that is below the upper one");
    if (until) checkUntil(node, hasUpper, hasLower, hasUpper ? upper : lower);
    const bool never = (hasUpper && (upper < row.least || (below && upper == row.least))) ||
                       (hasLower && (lower > row.most || (above && lower == row.most)));
    const bool always = (!hasUpper || upper > row.most || (atMost && upper == row.most)) &&
                        (!hasLower || lower < row.least || (atLeast && lower == row.least));
    if (never || always)
      complain(never ? "never holds" : "always holds",
               std::string(row.name) + " is " +
                   (row.most < INFINITY ? "from " + exactText(row.least) + " to " + exactText(row.most)
                                        : "at least " + exactText(row.least)));
  }

  void checkUntil(const Node& node, bool hasUpper, bool hasLower, double bound) {
    const Place& place = node.find("until")->place;
    const double until = *sense_.is.until;
    if (hasUpper && hasLower)
      problems().add(place, path_ + ".until", "stands beside two bounds", "give one bound, or no until");
    else if (hasUpper ? until <= bound : until >= bound)
      problems().add(place, path_ + ".until", exactText(until) + " is no farther than " + exactText(bound),
                     std::string("needs a number ") + (hasUpper ? "above" : "below") + " it, or remove this");
  }

  std::string path_;
  Reading& reading_;
  SenseParameters sense_;
};

/// Returns true for names that the simulator already uses.
bool isTaken(const std::string& name) {
  return name == substance::a || name == substance::b || name == "START" ||
         std::ranges::find(substance::acting, name) != substance::acting.end();
}

Json writeCondition(const SenseParameters& sense) {
  const SenseKindRow& row = kindOf(sense.kind);
  Json keys = Json::object();
  if (row.of.key && !sense.of.empty()) keys[row.of.key] = sense.of;
  if (row.takesLives && sense.of.empty()) keys["lives"] = sense.lives ? "true" : "false";
  if (row.number.key && sense.number) keys[row.number.key] = *sense.number;
  if (row.takesAxis) keys["axis"] = {sense.axis.x, sense.axis.y, sense.axis.z};
  for (const Bound& bound : bounds)
    if (sense.is.*bound.value) keys[bound.key] = *(sense.is.*bound.value);
  return {{row.name, keys}};
}

Json schemaOf(const SenseKindRow& row) {
  Json keys = Json::object(), required = Json::array();
  const Json text{{"type", "string"}, {"minLength", 1}};
  if (row.of.key) keys[row.of.key] = text;
  if (row.of.required) required.push_back(row.of.key);
  if (row.takesLives) keys["lives"] = {{"enum", {true, false, "true", "false"}}};
  if (row.number.key) keys[row.number.key] = numberSchema(positive);
  if (row.number.required) required.push_back(row.number.key);
  if (row.takesAxis) {
    keys["axis"] = listSchema({{"type", "number"}}, 3);
    required.push_back("axis");
  }
  if (!row.threshold)
    for (const Bound& bound : bounds) keys[bound.key] = {{"type", "number"}};
  Json condition{
      {"type", "object"}, {"description", row.meaning}, {"properties", keys}, {"additionalProperties", false}};
  if (!required.empty()) condition["required"] = required;
  return onlySchema(row.name, condition);
}

const char* nameOf(SenseNeeds needs) {
  switch (needs) {
    case SenseNeeds::nothing: return "nothing";
    case SenseNeeds::bodies: return "`physics`";
    case SenseNeeds::membrane: return "`physics.cell.model: shell`";
    case SenseNeeds::mesh: return "a `physics.cell.model` with meshes";
    case SenseNeeds::contact: return "`physics.contact`";
    case SenseNeeds::shell: return "`physics.shell`, cells with meshes";
    case SenseNeeds::connections: return "`connections`";
  }
  return "";
}

}  // namespace

Parameter senses() {
  Parameter p;
  p.path = "senses";
  p.allowed = std::string("a map of substances to ") + senseForm;
  p.meaning = "Senses of cells";
  Json forms = Json::array();
  for (const SenseKindRow* row : senseKinds()) forms.push_back(schemaOf(*row));
  p.schema = {{"additionalProperties", {{"oneOf", forms}}}};
  p.read = [](Scenario& s, const Node& node, Reading& reading) {
    for (const auto& member : node.members) {
      if (member.key.empty()) continue;
      const std::string path = "senses." + member.key;
      reading.senses.insert(member.key);
      if (isTaken(member.key))
        reading.problems.add(member.place, path, "'" + member.key + "' is a reserved substance of the simulator",
                             "take another name");
      if (const auto sense = SenseReader(path, reading).read(member)) s.scene.senses.push_back(*sense);
    }
    std::ranges::sort(s.scene.senses, {}, &SenseParameters::substance);
  };
  p.write = [](const Scenario& s) {
    Json map = Json::object();
    for (const SenseParameters& sense : s.scene.senses) map[sense.substance] = writeCondition(sense);
    return map;
  };
  return p;
}

std::string sensesAsMarkdown() {
  std::string text =
      "Each value is one condition, `{kind: {key: value}}`. A kind with bounds measures a number: `below`, `above`, "
      "`at-most` and `at-least` say when its condition begins to hold, and `until`, beside one bound, when it "
      "ceases to hold. `of`, `to` and `holds` name a substance, or the beginning of a name and `*`.\n\n| kind | "
      "keys | unit | needs | what is perceived |\n|---|---|---|---|---|\n";
  for (const SenseKindRow* row : senseKinds()) {
    std::string keys;
    const auto add = [&](const std::string& key, const std::string& unit = "") {
      keys += (keys.empty() ? "`" : ", `") + key + "`" + (unit.empty() ? "" : " [" + unit + "]");
    };
    if (row->of.key) add(row->of.key);
    if (row->takesLives) add("lives");
    if (row->number.key) add(row->number.key, row->number.unit);
    if (row->takesAxis) add("axis");
    if (!row->threshold) keys += keys.empty() ? "bounds" : ", bounds";
    text += "| `" + std::string(row->name) + "` | " + keys + " | " + row->unit + " | " + nameOf(row->needs) + " | " +
            markdownCell(row->meaning) + " |\n";
  }
  return text;
}

}  // namespace morula::scenario
