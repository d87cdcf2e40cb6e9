#include "study/study_table.h"

#include <algorithm>

#include "base/did_you_mean.h"
#include "files/text.h"
#include "observation/asked_measure.h"
#include "values/value_types.h"

namespace morula::study {

using scenario::Node;
using scenario::Problems;

namespace {

const std::string nameAllowed = "a name made of letters, digits, '-' and '_', at most 100 of them";

bool isName(const std::string& text) { return isMadeOf(text, "-_") && text.size() <= 100 && text[0] != '-'; }

Key version() {
  return {"morula-study",
          "1",
          "Version of this format",
          "",
          {{"const", 1}},
          [](Study&, const Node& node, Problems& problems) {
            scenario::readNatural(node, {1, 1}, "morula-study", "1", problems);
          }};
}

Key name() {
  return {"name",
          nameAllowed,
          "Name of the folder of the results",
          "",
          {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]{0,99}$"}},
          [](Study& study, const Node& node, Problems& problems) {
            const auto text = scenario::readText(node, "name", nameAllowed, problems);
            if (text && !isName(*text))
              problems.add(node.place, "name", describe(node) + " is not a name", "needs " + nameAllowed);
            else if (text) study.name = *text;
          }};
}

Key summary() {
  return {"summary",
          "a text",
          "Summary of the study in one line",
          "none",
          {{"type", "string"}},
          [](Study& study, const Node& node, Problems& problems) {
            study.summary = scenario::readText(node, "summary", "a text", problems).value_or("");
          }};
}

/// Returns the key of a map, whose members are keys of the table, too.
Key section(const char* path, const char* meaning, const char* absent) {
  return {path, "a map", meaning, absent, {{"type", "object"}}, {}};
}

template <class E>
Key choiceKey(const char* path, const char* what, E Kept::*field) {
  std::vector<std::string> names;
  std::string meaning = what;
  for (const auto& row : choices<E>) {
    names.push_back(row.name);
    meaning += std::string("; ") + row.name + ": " + row.meaning;
  }
  return {path,
          namesOf<E>(),
          meaning,
          nameOf(Kept{}.*field),
          {{"enum", names}},
          [=](Study& study, const Node& node, Problems& problems) {
            const auto text = scenario::readText(node, path, namesOf<E>(), problems);
            if (!text) return;
            if (const auto value = valueNamed<E>(*text)) study.keep.*field = *value;
            else refuseWord(node, path, names, namesOf<E>(), problems);
          }};
}

Key cpuPerRun() {
  const std::string allowed = scenario::numberAllowed(scenario::positive, "s");
  return {"limits.cpu-per-run",
          allowed,
          "Max CPU time of one run; a run that needs more is ended as failed",
          "no limit",
          scenario::numberSchema(scenario::positive),
          [allowed](Study& study, const Node& node, Problems& problems) {
            study.limits.cpu = scenario::readReal(node, scenario::positive, "limits.cpu-per-run", allowed, problems);
          }};
}

Key memoryPerRun() {
  static constexpr auto path = "limits.memory-per-run";
  const std::string allowed = "a size from 1M, as 500M or 2G (10⁶ or 10⁹ bytes)";
  return {path,
          allowed,
          "Max memory of one run; a run that needs more is ended as failed",
          "no limit",
          {{"type", Json::array({"string", "integer"})}, {"pattern", "^[0-9]+(\\.[0-9]+)?[kKMGT]?$"}},
          [allowed](Study& study, const Node& node, Problems& problems) {
            if (!node.isPlain()) return scenario::refuse(node, path, allowed, problems);
            const auto size = scenario::parseSize(node.text);
            if (!size.wrong.empty())
              problems.add(node.place, path, describe(node) + " " + size.wrong, "needs " + allowed);
            else if (!(size.value >= 1e6 && size.value <= 1e18))
              problems.add(node.place, path, node.text + " is out of range", "needs " + allowed);
            else study.limits.memory = static_cast<std::uint64_t>(size.value);
          }};
}

/// Returns the key of a limit on runs in a state that is not fine.
Key allowedKey(const char* path, const char* meaning, std::size_t AllowedRuns::*count) {
  constexpr std::uint64_t most = maxReplicates;
  const std::string allowed = "a whole number from 0 to " + std::to_string(most);
  return {path,
          allowed,
          meaning,
          "0",
          {{"type", "integer"}, {"minimum", 0}, {"maximum", most}},
          [=](Study& study, const Node& node, Problems& problems) {
            study.allowed.*count = scenario::readNatural(node, {0, most}, path, allowed, problems).value_or(0);
          }};
}

std::string parentOf(const std::string& path) {
  return path.find('.') == path.npos ? "" : path.substr(0, path.find('.'));
}
std::string lastOf(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::vector<std::string> keysIn(const std::string& parent) {
  std::vector<std::string> names;
  for (const Key& key : keys())
    if (parentOf(key.path) == parent) names.push_back(lastOf(key.path));
  return names;
}

std::string remedy(const std::string& parent, const std::string& word) {
  const auto here = keysIn(parent);
  if (const auto near = closest(word, here); !near.empty()) return "did you mean " + near + "?";
  for (const Key& key : keys())
    if (lastOf(key.path) == word) return "did you mean " + key.path + "?";
  return "known here: " + join(here);
}

void readMap(const std::string& parent, const Node& node, Study& study, Problems& problems) {
  if (node.kind == Node::Kind::broken) return;
  if (node.kind != Node::Kind::map) {
    if (parent.empty())
      problems.add(node.place, "", "the file is " + (node.kind == Node::Kind::null ? "empty" : describe(node)),
                   "a study is a map that begins with 'morula-study: 1'");
    else scenario::refuse(node, parent, "a map", problems);
    return;
  }
  const auto known = keysIn(parent);
  for (const auto& member : node.members)
    if (!member.key.empty() && std::ranges::find(known, member.key) == known.end())
      problems.add(member.place, parent.empty() ? member.key : parent + "." + member.key, "unknown key",
                   remedy(parent, member.key));
  if (!parent.empty() && node.members.empty())
    problems.add(node.place, parent, "is empty", "needs some of " + join(known));
  for (const Key& key : keys()) {
    if (parentOf(key.path) != parent) continue;
    const auto* member = node.find(lastOf(key.path));
    if (!member && key.absent.empty()) problems.add(node.place, key.path, "is missing", "needs " + key.allowed);
    if (!member) continue;
    if (key.read) key.read(study, member->value, problems);
    else readMap(key.path, member->value, study, problems);
  }
}

}  // namespace

void refuseWord(const Node& node, const std::string& path, const std::vector<std::string>& names,
                const std::string& allowed, Problems& problems) {
  const std::string near = closest(node.text, names);
  problems.add(node.place, path, describe(node) + " is not known here",
               (near.empty() ? "needs " : "did you mean " + near + "? Needs ") + allowed);
}

Json objectSchema(Json properties, Json required) {
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

const std::vector<Key>& keys() {
  static const std::vector<Key> list{
      version(),
      name(),
      summary(),
      baseKey(),
      varyKey(),
      leaveOutKey(),
      seedsKey(),
      measuresKey(),
      section("keep", "Data that are stored of each run besides the values of the measures", "the defaults"),
      choiceKey("keep.hashes", "Hashes of states, with which runs are compared", &Kept::hashes),
      choiceKey("keep.samples", "Samples of cells: places, shapes, contacts", &Kept::samples),
      choiceKey("keep.pictures", "Pictures of organisms at the end", &Kept::pictures),
      section("limits", "Limits of one run, and max numbers of runs that fail or are insane",
              "no limits for a run; no run may fail or be insane"),
      cpuPerRun(),
      memoryPerRun(),
      allowedKey("limits.failed",
                 "Max number of failed runs. With more, study run, status and check and compare end with exit code 1",
                 &AllowedRuns::failed),
      allowedKey("limits.insane",
                 "Max number of insane runs, whose final state is not possible (kind sanity of check_result). With "
                 "more, study run, status and check and compare end with exit code 1",
                 &AllowedRuns::insane),
      checkKey()};
  return list;
}

void readKeys(const Node& root, Study& study, Problems& problems) { readMap("", root, study, problems); }

}  // namespace morula::study
