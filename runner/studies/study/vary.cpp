// The axes of a study: their names, and the overrides of their levels.
#include <algorithm>
#include <map>

#include "base/did_you_mean.h"
#include "base/maths.h"
#include "base/number_text.h"
#include "files/text.h"
#include "study/study_table.h"
#include "values/value_types.h"

namespace morula::study {

using scenario::Member;
using scenario::Node;
using scenario::Place;
using scenario::Problems;

namespace {

const std::string varyAllowed =
    "a map of axes, each a map of labels, as division: {longest: {division.plane: longest}}";
const std::string levelAllowed = "a map of scenario keys; {} for the scenario as it is";

/// Names of columns and values that results use themselves.
const std::vector<std::string> reserved{"base",     "condition_id", "uses_seed", "distinct_runs", "run_id", "task_id",
                                        "seed",     "measure",      "time",      "value",         "labels", "n",
                                        "distinct", "mean",         "low",       "high",          "number"};

/// Keys of scenarios that a study may not vary, and where they are set.
const std::map<std::string, std::string> saidElsewhere{
    {"morula", "the format is given by each scenario itself"},
    {"name", "labels name the conditions"},
    {"summary", "labels name the conditions"},
    {"seed", "seeds are given by the study's key `seeds`"},
    {"record", "records are given by the study's keys `measures` and `keep`"}};

bool isAxisName(const std::string& text) { return isLabel(text) && text.find_first_of(".+") == text.npos; }

bool isPath(const std::string& key) { return key.front() != '.' && key.back() != '.' && key.find("..") == key.npos; }

/// Quotes a text as JSON, which is valid YAML, too.
std::string jsonQuoted(const std::string& text) { return jsonText(Json(text)); }

/// Returns true if a text needs no quotes within brackets, where some characters end a text or begin another value.
bool staysPlain(const std::string& text) { return isMadeOf(text, "_.+-/") && text != "-"; }

std::string flow(const Node& node) {
  std::string text;
  switch (node.kind) {
    case Node::Kind::scalar: return node.isPlain() && staysPlain(node.text) ? node.text : jsonQuoted(node.text);
    case Node::Kind::sequence:
      for (const Node& item : node.items) text += (text.empty() ? "" : ", ") + flow(item);
      return "[" + text + "]";
    case Node::Kind::map:
      for (const auto& member : node.members)
        text += (text.empty() ? "" : ", ") + (staysPlain(member.key) ? member.key : jsonQuoted(member.key)) + ": " +
                flow(member.value);
      return "{" + text + "}";
    default: return "null";
  }
}

/// Returns true for a path of keys that a study may vary, and adds a problem for any other.
bool mayVary(const std::string& key, const Place& place, const std::string& at, Problems& problems) {
  if (!isPath(key)) {
    problems.add(place, at, "is no scenario key", "needs names with dots between them, as division.plane");
    return false;
  }
  const auto said = saidElsewhere.find(key.substr(0, key.find('.')));
  if (said != saidElsewhere.end()) problems.add(place, at, "cannot be varied", said->second);
  return said == saidElsewhere.end();
}

void readLevel(StudyAxis& axis, const Member& member, Problems& problems) {
  const std::string path = "vary." + axis.name + "." + member.key;
  if (!isLabel(member.key)) return problems.add(member.place, path, "'" + member.key + "' is no label", labelNeeds);
  if (member.value.kind != Node::Kind::map) return scenario::refuse(member.value, path, levelAllowed, problems);
  Level level{member.key, {}};
  for (const Member& change : member.value.members) {
    if (change.key.empty() || change.value.kind == Node::Kind::broken) continue;
    if (!mayVary(change.key, change.place, path + "." + change.key, problems)) continue;
    level.overrides.push_back({change.key, overrideText(change.value),
                               scenario::placeText(problems.file(), change.value.place),
                               change.value.kind == Node::Kind::null});
  }
  axis.levels.push_back(std::move(level));
}

/// Reads {key: physics.drag, from: 1, to: 16, steps: 5, log: true}: the labels of the levels are their values.
void readRange(StudyAxis& axis, const Node& node, const std::string& path, Problems& problems) {
  scenario::refuseUnknown(node, path, {"key", "from", "to", "steps", "log"}, problems);
  const std::size_t before = problems.size();
  const Member& key = *node.find("key");
  const auto text = scenario::readText(key.value, path + ".key", "a scenario key", problems);
  const Member* log = node.find("log");
  const bool isLog = log && log->value.text == "true";
  if (log && !isLog && log->value.text != "false")
    problems.add(log->place, path + ".log", "is " + describe(log->value), "needs true or false");
  const scenario::Range range{.low = isLog ? 0 : -1e300, .high = 1e300, .openLow = isLog};
  const auto number = [&](const char* name) {
    const auto value = scenario::readMember(node, name, range, "", path, problems);
    if (!value && !node.find(name)) problems.add(node.place, path + "." + name, "is missing", "needs a number");
    return value;
  };
  const auto from = number("from"), to = number("to");
  const Member* count = node.find("steps");
  std::optional<std::uint64_t> steps;
  if (!count) problems.add(node.place, path + ".steps", "is missing", "needs the number of levels, as steps: 5");
  else
    steps = scenario::readNatural(count->value, {2, 1000}, path + ".steps", "a whole number from 2 to 1000", problems);
  if (text) mayVary(*text, key.value.place, path + ".key", problems);
  if (from && to && *from == *to)
    problems.add(node.place, path, "from and to are the same", "give two different numbers");
  if (problems.size() > before) return;
  const std::string place = scenario::placeText(problems.file(), key.value.place);
  for (std::uint64_t i = 0; i < *steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(*steps - 1);
    const double exact = i + 1 == *steps ? *to
                         : isLog         ? *from * exponential(share * naturalLog(*to / *from))
                                         : *from + (*to - *from) * share;
    // Six digits make labels short, and the value is what the label says.
    const std::string value = i == 0 || i + 1 == *steps ? exactText(exact) : numberText(exact, 6);
    if (i > 0 && axis.levels.back().overrides[0].value == value)
      return problems.add(node.place, path, "two levels are the same in six digits, " + value,
                          "needs fewer steps, or from and to farther apart");
    axis.levels.push_back({value[0] == '-' ? "minus" + value : value, {{*text, value, place, false}}});
  }
}

void readAxis(Study& study, const Member& member, Problems& problems) {
  const std::string path = "vary." + member.key;
  if (!isAxisName(member.key))
    return problems.add(member.place, path, "'" + member.key + "' is no name of an axis",
                        "needs letters, digits, '-' and '_', a letter or digit first, at most 50 of them");
  if (std::ranges::any_of(reserved, [&](const std::string& word) { return equalButForCase(word, member.key); }))
    return problems.add(member.place, path, "results have a column of this name already", "rename the axis");
  for (const StudyAxis& other : study.axes)
    if (equalButForCase(other.name, member.key))
      return problems.add(member.place, path, "has the same name as " + other.name + " but for case",
                          "rename one of them");
  StudyAxis axis{member.key, {}};
  if (member.value.kind != Node::Kind::map)
    return scenario::refuse(member.value, path, "a map of labels, as {longest: {division.plane: longest}}", problems);
  if (member.value.members.empty())
    return problems.add(member.value.place, path, "is empty",
                        "needs a map of labels, as {longest: {division.plane: longest}}");
  if (const Member* key = member.value.find("key"); key && key->value.kind == Node::Kind::scalar)
    readRange(axis, member.value, path, problems);
  else
    for (const Member& level : member.value.members)
      if (!level.key.empty()) readLevel(axis, level, problems);
  study.axes.push_back(std::move(axis));
}

void readVary(Study& study, const Node& node, Problems& problems) {
  if (node.kind != Node::Kind::map) return scenario::refuse(node, "vary", varyAllowed, problems);
  if (node.members.empty())
    return problems.add(node.place, "vary", "is empty", "needs " + varyAllowed + ", or remove it");
  for (const Member& member : node.members)
    if (!member.key.empty()) readAxis(study, member, problems);
}

}  // namespace

std::string overrideText(const Node& node) {
  // Outside of brackets, a text without quotes reaches to the end, unless its beginning means something else.
  if (node.isPlain() && !node.text.empty() && std::string_view("[{\"'").find(node.text[0]) == std::string_view::npos)
    return node.text;
  return flow(node);
}

Key varyKey() {
  const Json level{{"type", "object"}, {"description", "Scenario keys and their values; null removes a part"}};
  const Json labels{{"type", "object"}, {"additionalProperties", level}, {"minProperties", 1}};
  const Json number{{"type", "number"}};
  const Json range = scenario::mapSchema({{"key", {{"type", "string"}, {"minLength", 1}}},
                                          {"from", number},
                                          {"to", number},
                                          {"steps", {{"type", "integer"}, {"minimum", 2}, {"maximum", 1000}}},
                                          {"log", {{"type", "boolean"}}}},
                                         {"key", "from", "to", "steps"});
  const Json axis{{"anyOf", Json::array({labels, range})}};
  return {
      "vary",
      varyAllowed,
      "Axes of the design: each condition has one level of each axis, and all combinations are run that leave-out does not name. A level "
      "sets any keys of a scenario, as --set does; null removes a part, {} leaves the scenario unchanged. An axis "
      "of numbers: {key: physics.drag, from: 1, to: 16, steps: 5, log: true}",
      "one condition: the scenario as it is",
      {{"type", "object"}, {"additionalProperties", axis}, {"minProperties", 1}},
      readVary};
}

std::set<std::string> checkAxes(const Study& study, Problems& problems) {
  std::set<std::string> wrong;
  struct Use {
    const StudyAxis* axis;
    const Override* change;
  };
  std::map<std::string, std::vector<Use>> uses;  // for each path, one use an axis
  for (const StudyAxis& axis : study.axes)
    for (const Level& level : axis.levels)
      for (const Override& change : level.overrides) {
        auto& list = uses[change.path];
        if (std::ranges::none_of(list, [&](const Use& use) { return use.axis == &axis; }))
          list.push_back({&axis, &change});
        // Within a level, a key may clash with a part of it.
        for (const Override& other : level.overrides)
          if (change.path.starts_with(other.path + "."))
            problems.addForeign({}, change.place + ": " + change.path + ": lies within " + other.path +
                                        ", which the same level sets; write it there");
      }
  for (const auto& [path, list] : uses)
    for (std::size_t end = path.find('.');; end = path.find('.', end + 1)) {
      const std::string whole = path.substr(0, end);
      if (const auto found = uses.find(whole); found != uses.end())
        for (const Use& use : list)
          for (const Use& other : found->second) {
            if (use.axis == other.axis || (whole == path && use.axis < other.axis)) continue;
            problems.addForeign(
                {}, use.change->place + ": " + path + ": " +
                        (whole == path ? "is set by axis " : "lies within " + whole + ", which is set by axis ") +
                        other.axis->name + ", too; let one axis set both");
            wrong.insert(use.axis->name);
          }
      if (end == path.npos) break;
    }
  return wrong;
}

}  // namespace morula::study
