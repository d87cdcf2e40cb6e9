#include "check/golden_scenario.h"

#include <algorithm>
#include <set>

#include "base/error.h"
#include "golden/change.h"
#include "scenario/deciding_values.h"
#include "system/git_text.h"

namespace morula {
namespace {

using Values = std::vector<std::pair<std::string, std::string>>;

/// Values of the golden as one value in YAML's flow style: members of maps by their names, of lists by "[i]".
struct Tree {
  std::string name, value;
  std::vector<Tree> members;  // in the golden's order

  Tree& member(const std::string& wanted) {
    for (Tree& tree : members)
      if (tree.name == wanted) return tree;
    members.push_back({wanted, "", {}});
    return members.back();
  }

  std::string text() const {
    if (members.empty()) return value;
    const bool isList = members[0].name.starts_with('[');
    std::string inner;
    for (const Tree& tree : members)
      inner += (inner.empty() ? "" : ", ") + (isList ? "" : tree.name + ": ") + tree.text();
    return isList ? '[' + inner + ']' : '{' + inner + '}';
  }
};

/// "physics.contact.law" → physics, contact, law; "division.rules[0].of" → division, rules, [0], of.
std::vector<std::string> partsOf(const std::string& key) {
  std::vector<std::string> parts{""};
  for (const char c : key) {
    if (c == '.') parts.emplace_back();
    else if (c == '[') parts.emplace_back("[");
    else parts.back() += c;
  }
  return parts;
}

/// The part of a key that an override can name: a list is given whole.
std::string settable(const std::string& key) { return key.substr(0, key.find('[')); }

/// The largest map that the golden knows nothing of and that holds the key: with the last value of a section goes the
/// section. Nothing where the golden has a value of its own for such a map.
std::optional<std::string> toRemove(const std::string& key, const Values& golden) {
  for (std::size_t dot = key.find('.'); dot != key.npos; dot = key.find('.', dot + 1)) {
    const std::string section = key.substr(0, dot);
    const auto has = [&](auto fits) { return std::any_of(golden.begin(), golden.end(), fits); };
    if (has([&](const auto& v) { return v.first == section; })) return std::nullopt;
    if (!has([&](const auto& v) { return v.first.starts_with(section + '.'); })) return section;
  }
  return key;
}

/// Returns the overrides that turn `now` into the golden's scenario.
std::vector<Override> overridesTo(const GoldenData& golden, const GoldenData& now) {
  std::set<std::string> paths, removed;
  for (const KeyChange& change : changedKeys(golden, now)) paths.insert(settable(change.key));
  std::vector<Override> overrides;
  for (const std::string& path : paths) {
    Tree tree;
    bool known = false;
    for (const auto& [key, value] : golden.parameters) {
      if (settable(key) != path) continue;
      known = true;
      Tree* at = &tree;
      for (const std::string& part : partsOf(key.substr(path.size())))
        if (!part.empty()) at = &at->member(part);
      at->value = value;
    }
    const std::string place = "the golden's " + path;
    if (known) overrides.push_back({path, tree.text(), place});
    else if (const auto top = toRemove(path, golden.parameters); top && removed.insert(*top).second)
      overrides.push_back({*top, "null", place, true});
  }
  return overrides;
}

bool isMeant(const Scenario& scenario, const Golden& golden) {
  return scenario.meaning.text() == golden.data.scenarioHash ||
         (!golden.data.parameters.empty() && decidingValues(scenario) == golden.data.parameters);
}

/// The scenario that is read so, if it is the golden's.
template <class Read>
std::optional<Scenario> ifMeant(const Golden& golden, Read read) {
  try {
    Scenario scenario = read();
    if (isMeant(scenario, golden)) return scenario;
  } catch (const InputError&) {  // another version's, or values that do not go together
  } catch (const FileError&) {   // a file that it named is gone
  }
  return std::nullopt;
}

std::optional<Scenario> withGoldenValues(const Scenario& now, const Golden& golden) {
  if (golden.data.parameters.empty()) return std::nullopt;
  GoldenData ofNow;
  ofNow.parameters = decidingValues(now);
  const auto overrides = overridesTo(golden.data, ofNow);
  const auto read = [&](const std::vector<NamedFile>& files) {
    return ifMeant(golden, [&] {
      return readScenario(now.bytes, now.file, folderOf(now.file), overrides, files, now.allowOutside);
    });
  };
  // The files of a stored run are stored with it; a golden may name others.
  if (auto scenario = read(now.files)) return scenario;
  return read({});
}

std::optional<Scenario> asCommitted(const Scenario& now, const Golden& golden, const std::string& commit) {
  const auto text = committedText(now.file, commit);
  if (!text) return std::nullopt;
  std::vector<NamedFile> files;
  for (const NamedFile& file : now.files)
    if (auto content = committedText(file.path, commit)) files.push_back({file.role, file.path, std::move(*content)});
  return ifMeant(golden,
                 [&] { return readScenario(*text, now.file, folderOf(now.file), {}, files, now.allowOutside); });
}

}  // namespace

std::optional<Scenario> goldenScenario(const Scenario& now, const Golden& golden) {
  if (isMeant(now, golden)) return now;
  if (auto changed = withGoldenValues(now, golden)) return changed;
  if (const auto commit = lastCommitOf(golden.file))
    if (auto committed = asCommitted(now, golden, *commit)) return committed;
  return asCommitted(now, golden, "HEAD");
}

}  // namespace morula
