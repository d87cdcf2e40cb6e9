#include "scenario/scenario.h"

#include "base/error.h"
#include "biology/substance_pattern.h"
#include "files/read_file.h"
#include "scenario/scene_checks.h"

namespace morula {
namespace {

using namespace scenario;

void applyOverrides(Node& root, const std::vector<Override>& overrides, Problems& problems) {
  for (const auto& change : overrides) {
    const Place place{1, 1, change.place};
    for (const auto& other : overrides)
      if (&other < &change && other.path == change.path)
        problems.add(place, change.path, "given twice", "keep one of '" + other.value + "' and '" + change.value + "'");
    const auto& table = parameterTable();
    if (change.removes && (remove(root, change.path) || table.section(change.path) || table.parameter(change.path)))
      continue;
    const std::string list = assign(root, change.path, readYamlValue(change.value, change.place, problems));
    if (!list.empty())
      problems.add(place, change.path, "the list " + list + " has no entry of this name, or several",
                   "needs a text that one entry alone has under of or name, as " + list + ".NAME");
  }
}

void notePlaces(const Node& node, const std::string& path, Scenario& scenario) {
  if (!path.empty()) scenario.places[path] = placeText(scenario.file, node.place);
  for (const auto& member : node.members)
    notePlaces(member.value, path.empty() ? member.key : path + "." + member.key, scenario);
}

}  // namespace

Override parseOverride(const std::string& text) {
  const auto equals = text.find('=');
  const auto path = text.substr(0, equals);
  if (equals == text.npos || path.empty() || path.front() == '.' || path.back() == '.' || path.find("..") != path.npos)
    throw InputError("--set " + text + ": is not an assignment; needs path=value, as physics.time_step=0.001");
  const auto value = text.substr(equals + 1);
  return {path, value, "--set " + path, value == "null" || value == "~"};
}

Scenario readScenario(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                      const std::vector<Override>& overrides, const std::vector<NamedFile>& files, bool allowOutside) {
  Scenario result;
  result.file = name;
  result.bytes = bytes;
  result.allowOutside = allowOutside;

  Problems problems(name);
  const SourceText source(bytes, problems);
  problems.throwIfAny();
  auto root = readYaml(source, problems);
  if (root.kind == Node::Kind::broken) problems.throwIfAny();
  if (root.kind == Node::Kind::map) applyOverrides(root, overrides, problems);

  if (const auto* study = root.find("morula-study")) {
    problems.add(study->place, "morula-study", "the file is a study, not a scenario",
                 "morula study plan tells what it computes, morula study run runs it");
    problems.throwIfAny();
  }

  Reading reading{problems, {}, {}, {}};
  readTable(root, result, reading);
  readReferences(result, reading, root, {folder, files, allowOutside});
  crossCheck(result, reading, root);
  problems.throwIfAny();

  result.warnings = result.scene.dna.warnings;
  for (const auto& warningsOf : {sizeWarnings, intervalWarnings, descentWarnings})
    for (std::string& warning : warningsOf(result, root)) result.warnings.push_back(std::move(warning));
  notePlaces(root, "", result);
  resolveAgain(result);
  return result;
}

void resolveAgain(Scenario& scenario) {
  scenario.resolved = writeJson(resolve(scenario));
  scenario.meaning = hashMeaning(scenario);
  scenario.referenceMeaning.reset();
  if (!scenario.check.reference) return;
  Hasher hasher;
  addReference(hasher, scenario);
  scenario.referenceMeaning = hasher.digest();
}

Scenario withSeed(Scenario scenario, std::uint64_t seed) {
  scenario.scene.seed = seed;
  resolveAgain(scenario);
  return scenario;
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

Scenario loadScenario(const std::filesystem::path& file, const std::vector<Override>& overrides, bool allowOutside) {
  return readScenario(readFile(file), file.string(), folderOf(file), overrides, {}, allowOutside);
}

const std::pair<const std::string, std::string>* colourEntryOf(const Scenario& scenario, const std::string& substance) {
  if (const auto exact = scenario.colours.find(substance); exact != scenario.colours.end()) return &*exact;
  const std::pair<const std::string, std::string>* found = nullptr;
  for (const auto& entry : scenario.colours) {
    const std::string& pattern = entry.first;
    if (pattern.empty() || pattern.back() != '*') continue;
    // '*' sorts before all characters of names, so the longest of the patterns that fit comes last.
    if (fits(pattern, substance)) found = &entry;
  }
  return found;
}

const CellColour* cellColourOf(const Scenario& scenario, const CellPath& cell) {
  const auto rank = [](const CellSelection& cells) {  // the larger, the nearer to the cell
    if (cells.kind == CellSelection::Kind::cell) return CellPath::maxDepth + 1;
    return cells.kind == CellSelection::Kind::clone ? cells.path.depth() : -1;
  };
  const CellColour* found = nullptr;
  for (const CellColour& one : scenario.cellColours)
    if (one.cells.has(cell, "") && (!found || rank(one.cells) > rank(found->cells))) found = &one;
  return found;
}

std::optional<std::string> colourOf(const Scenario& scenario, const std::string& substance) {
  const auto* entry = colourEntryOf(scenario, substance);
  return entry ? std::optional(entry->second) : std::nullopt;
}

}  // namespace morula
