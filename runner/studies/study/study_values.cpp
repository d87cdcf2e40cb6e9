// Values of a study file: scenarios, seeds, measures and when they are taken.
#include <algorithm>
#include <iterator>
#include <map>
#include <optional>

#include "base/error.h"
#include "files/text.h"
#include "observation/asked_measure.h"
#include "study/study_table.h"
#include "study_store/study_tables.h"
#include "values/value_types.h"

namespace morula::study {

using scenario::Node;
using scenario::Problems;

namespace {

const std::string baseAllowed = "a scenario file, a list of them, or a map of labels and files";

void addBase(Study& study, const Node& node, std::string label, Problems& problems) {
  const auto file = scenario::readText(node, "base", baseAllowed, problems);
  if (!file) return;
  if (file->empty()) return problems.add(node.place, "base", "is empty", "needs " + baseAllowed);
  const bool own = label.empty();
  if (own) label = std::filesystem::path(*file).stem().string();
  for (const Base& other : study.bases)
    if (other.label == label)
      return problems.add(node.place, "base", "'" + label + "' is given twice",
                          "give labels of their own, as base: {small: a.yaml, large: b.yaml}");
  if (!isLabel(label))
    return problems.add(node.place, "base", "'" + label + "' is no label",
                        own ? "give one, as base: {small: " + *file + "}" : labelNeeds);
  study.bases.push_back({label, *file, node.place});
}

void readBase(Study& study, const Node& node, Problems& problems) {
  if (node.kind == Node::Kind::sequence) {
    scenario::expectEntries(node, "base", baseAllowed, problems);
    for (const Node& item : node.items) addBase(study, item, "", problems);
  } else if (node.kind == Node::Kind::map) {
    if (node.members.empty()) problems.add(node.place, "base", "is empty", "needs " + baseAllowed);
    for (const auto& member : node.members)
      if (!member.key.empty()) addBase(study, member.value, member.key, problems);
  } else {
    addBase(study, node, "", problems);
  }
}

const std::string seedsAllowed = "whole numbers: one, FIRST..LAST as 1..10, or a list of such";

struct SeedRange {
  std::uint64_t first = 0, last = 0;
};

/// Reads "7" or "1..10"; absent and a problem for anything else.
std::optional<SeedRange> readSeedRange(const Node& node, Problems& problems) {
  const auto complain = [&](const std::string& what) {
    problems.add(node.place, "seeds", what, "needs " + seedsAllowed);
    return std::nullopt;
  };
  if (node.kind == Node::Kind::scalar && !node.isPlain()) return complain(describe(node) + " is in quotes");
  if (!node.isPlain()) return scenario::refuse(node, "seeds", seedsAllowed, problems), std::nullopt;
  const auto dots = node.text.find("..");
  const auto first = scenario::parseNatural(node.text.substr(0, dots));
  const auto last = dots == node.text.npos ? first : scenario::parseNatural(node.text.substr(dots + 2));
  for (const auto& end : {first, last}) {
    if (!end.wrong.empty()) return complain(describe(node) + " " + end.wrong);
    if (end.value > scenario::largestNatural) return complain(node.text + " is out of range");
  }
  if (last.value < first.value) return complain(node.text + " runs backward");
  return SeedRange{first.value, last.value};
}

void readSeeds(Study& study, const Node& node, Problems& problems) {
  const bool isList = node.kind == Node::Kind::sequence;
  if (isList) scenario::expectEntries(node, "seeds", seedsAllowed, problems);
  std::map<std::uint64_t, std::uint64_t> known;  // ranges without a common seed: last by first
  for (const Node& item : isList ? node.items : std::vector<Node>{node}) {
    const auto range = readSeedRange(item, problems);
    if (!range) continue;
    const auto after = known.upper_bound(range->first);
    const bool begun = after != known.begin() && std::prev(after)->second >= range->first;
    if (begun || (after != known.end() && after->first <= range->last)) {
      problems.add(item.place, "seeds", std::to_string(begun ? range->first : after->first) + " is given twice",
                   "each seed is run once: remove one of them");
      continue;
    }
    if (range->last - range->first >= maxReplicates - study.seeds.size()) {  // before any seed is kept
      const std::string before =
          study.seeds.empty() ? "" : " and the " + std::to_string(study.seeds.size()) + " before it";
      problems.add(item.place, "seeds",
                   item.text + before + " are too many, more than " + std::to_string(maxReplicates),
                   "needs " + seedsAllowed);
      break;
    }
    known.emplace(range->first, range->last);
    for (auto seed = range->first; seed <= range->last; ++seed) study.seeds.push_back(seed);
  }
}

const std::string measuresAllowed =
    "a list of measures, as [sister-contact, shell-share of AAA*], or {names: [...], when: each-division}";
const std::string whenAllowed = "end, each-division or {every: T}";

void readMeasureNames(Study& study, const Node& node, const std::string& path, Problems& problems) {
  if (!scenario::expectEntries(node, path, measuresAllowed, problems)) return;
  for (const Node& item : node.items) {
    const auto text = scenario::readText(item, path, "a measure's name", problems);
    if (!text) continue;
    try {
      for (const AskedMeasure& m : eachClone(readMeasure(*text))) {
        if (std::ranges::find(study.measures, m.name) != study.measures.end()) {
          problems.add(item.place, path, "'" + *text + "' is given twice", "remove it");
          break;
        }
        study.measures.push_back(m.name);
        study.measurePlaces.push_back(item.place);
      }
    } catch (const InputError& error) { addReadError(item.place, path, error, problems); }
  }
}

void readWhen(Study& study, const Node& node, Problems& problems) {
  const std::string path = "measures.when";
  if (node.kind == Node::Kind::map) {
    if (const auto* every = scenario::readOnly(node, path, {"every"}, whenAllowed, problems))
      if (const auto time = scenario::readReal(every->value, scenario::positive, path + ".every",
                                               scenario::numberAllowed(scenario::positive, "time"), problems))
        study.when = {Moments::every, *time};
    return;
  }
  const auto text = scenario::readText(node, path, whenAllowed, problems);
  if (!text) return;
  const auto moments = valueNamed<Moments>(*text);
  if (moments && *moments != Moments::every) study.when = {*moments};
  else refuseWord(node, path, {nameOf(Moments::end), nameOf(Moments::eachDivision)}, whenAllowed, problems);
}

void readMeasures(Study& study, const Node& node, Problems& problems) {
  if (node.kind != Node::Kind::map) return readMeasureNames(study, node, "measures", problems);
  scenario::refuseUnknown(node, "measures", {"names", "when"}, problems);
  if (const auto* names = node.find("names")) readMeasureNames(study, names->value, "measures.names", problems);
  else problems.add(node.place, "measures.names", "is missing", "needs " + measuresAllowed);
  if (const auto* when = node.find("when")) readWhen(study, when->value, problems);
}

}  // namespace

bool isLabel(const std::string& text) {
  return isMadeOf(text, "._+-") && text.size() <= 50 && isMadeOf(text.substr(0, 1), "");
}

Key baseKey() {
  const Json file{{"type", "string"}, {"minLength", 1}};
  return {"base",
          baseAllowed,
          "Scenario files, relative to the study's folder. Several scenarios make an axis of their own, base, the "
          "first",
          "",
          {{"oneOf", Json::array({file,
                                  {{"type", "array"}, {"items", file}, {"minItems", 1}},
                                  {{"type", "object"}, {"additionalProperties", file}, {"minProperties", 1}}})}},
          readBase};
}

Key seedsKey() {
  const Json natural{{"type", "integer"}, {"minimum", 0}};
  const Json range{{"type", "string"}, {"pattern", "^[0-9]+\\.\\.[0-9]+$"}};
  const Json one{{"oneOf", Json::array({natural, range})}};
  return {"seeds",
          seedsAllowed,
          "Seeds; each condition is run with each seed, in their order",
          "",
          {{"oneOf", Json::array({natural, range, {{"type", "array"}, {"items", one}, {"minItems", 1}}})}},
          readSeeds};
}

Key measuresKey() {
  const Json names = scenario::measuresSchema(allMeasures());
  const Json when{
      {"oneOf", Json::array({{{"enum", Json::array({"end", "each-division"})}},
                             objectSchema({{"every", scenario::numberSchema(scenario::positive)}}, {"every"})})}};
  return {
      "measures",
      measuresAllowed,
      "Measures [scenarios/MEASURES.md]: of the organism; of its cells, in the mean over living cells; of pairs, in "
      "the mean over pairs that touch. `of` after a measure selects cells: shell-share of AAA* (a path of daughters "
      "from the egg on; with `*` all that descend from it), volume of cell ABp or of clone ABp (by name, with all that "
      "descend from her), neighbours of skin (cells that hold a substance; s* for all that begin so), elongation of "
      "generation 3; `count of skin` counts these cells; shell-share of clones gives one measure for each clone, AA* to "
      "BB*; `distance cell ABa cell P2` is between centres; `a / b` and `a - b` are of two measures; clone-radius of "
      "generation 3 takes the organism's clones at "
      "another depth. when: end, the default: measures of the last state; each-division: also of the first state, "
      "and after each step in which cells divided; {every: T}: also of the first state, and every T units of time. "
      "A '-' may stand for a '_', and where two tables have one name the scope stands before it: cell.volume",
      "",
      {{"oneOf", Json::array({names, objectSchema({{"names", names}, {"when", when}}, {"names"})})}},
      readMeasures};
}

}  // namespace morula::study
