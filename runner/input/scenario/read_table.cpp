#include <algorithm>

#include "base/did_you_mean.h"
#include "files/text.h"
#include "scenario/loading.h"
#include "values/former_words.h"

namespace morula::scenario {
namespace {

std::string inside(const std::string& section, const std::string& key) {
  return section.empty() ? key : section + "." + key;
}

std::vector<std::string> keysOf(const std::string& section) {
  std::vector<std::string> keys;
  for (const auto* p : parameterTable().parametersOf(section)) keys.push_back(p->key());
  for (const auto* s : parameterTable().sectionsOf(section)) keys.push_back(s->key());
  return keys;
}

/// Returns true if a key only refines or accompanies other keys of its section.
bool refines(const std::string& section, const std::string& key) {
  const auto* parameter = parameterTable().parameter(inside(section, key));
  return parameter && (!parameter->needs.empty() || parameter->beside);
}

/// Returns the path of a section or a parameter elsewhere that has this key; "" if there is none.
std::string pathElsewhere(const std::string& key) {
  for (const auto& s : parameterTable().sections)
    if (s.key() == key) return s.path;
  for (const auto& p : parameterTable().parameters)
    if (p.key() == key) return p.path;
  return {};
}

/// Suggests what an unknown key was meant to be. At the top, a key of some section has probably been misplaced. Within
/// a section, a namesake elsewhere is only mentioned.
std::string remedy(const std::string& section, const std::string& key) {
  const auto here = keysOf(section);
  if (const auto near = closest(key, here); !near.empty()) return "did you mean " + near + "?";
  const std::string other = pathElsewhere(key);
  if (!other.empty() && (section.empty() || here.empty())) return "did you mean " + other + "?";
  const std::string known = here.empty() ? "this map takes no keys yet: write {}" : "known here: " + join(here);
  return other.empty() ? known : known + "; there is " + other + ", which is something else";
}

bool joins(const std::string& section, const std::string& key) {
  const auto* parameter = parameterTable().parameter(inside(section, key));
  return parameter && parameter->joins;
}

class TableReader {
 public:
  TableReader(const Node& root, Scenario& scenario, Reading& reading)
      : root_(root), scenario_(scenario), reading_(reading) {}

  void read(const Section& section, const Node& node) {
    if (node.kind == Node::Kind::broken) return;
    if (node.kind != Node::Kind::map) {
      const bool whole = section.path.empty();
      reading_.problems.add(
          node.place, section.path,
          (whole ? "the file is " : "is ") + (node.kind == Node::Kind::null ? "empty" : describe(node)),
          whole ? "a scenario is a map that begins with 'morula: 1'" : "needs a map; {} for defaults");
      return;
    }
    if (section.make) section.make(scenario_);
    if (section.entries) return section.entries->read(scenario_, node, reading_);
    checkKeys(section, node);
    for (const auto* parameter : parameterTable().parametersOf(section.path)) {
      const auto* member = node.find(parameter->key());
      if (!member && parameter->required) missing(node, parameter->path, "needs " + parameter->allowed);
      if (!member) continue;
      if (parameter->needs.empty() || node.find(parameter->needs)) parameter->read(scenario_, member->value, reading_);
      else
        reading_.problems.add(member->place, parameter->path, "has no effect without " + parameter->needs,
                              "give both, or remove this");
    }
    for (const auto* child : parameterTable().sectionsOf(section.path)) {
      const auto* member = node.find(child->key());
      if (!member && child->required) {
        std::vector<std::string> keys = keysOf(child->path);
        std::erase_if(keys, [&](const std::string& key) { return refines(child->path, key); });
        missing(node, child->path, "needs at least one of " + join(keys));
      }
      if (!member) continue;
      // Only top-level sections are ever needed by others.
      if (!child->needs.empty() && !root_.find(child->needs))
        reading_.problems.add(member->place, child->path, "has no effect without " + child->needs,
                              "add '" + child->needs + ": {}' or remove this");
      else if (child->needs.empty() || isThere(child->needs)) read(*child, member->value);
    }
  }

 private:
  /// Returns false for a section that could not be read, which has been reported: nothing may be put into it.
  bool isThere(const std::string& path) const {
    const Section* section = parameterTable().section(path);
    return section && section->existsIn(scenario_);
  }

  void missing(const Node& node, const std::string& path, const std::string& right) {
    reading_.problems.add(node.place, path, "is missing", right);
  }

  void checkKeys(const Section& section, const Node& node) {
    const auto known = keysOf(section.path);
    std::vector<const Member*> good;  // known keys that stand for themselves
    bool unknown = false;
    for (const auto& member : node.members) {
      if (member.key.empty()) continue;
      if (std::find(known.begin(), known.end(), member.key) != known.end()) {
        if (!refines(section.path, member.key)) good.push_back(&member);
        continue;
      }
      unknown = true;
      const std::string path = inside(section.path, member.key);
      if (const FormerWord* former = formerKey(path))
        reading_.problems.add(member.place, path,
                              "is called " + std::string(former->now) + " now: " + std::string(former->reason),
                              std::string(former->remedy));
      else reading_.problems.add(member.place, path, "unknown key", remedy(section.path, member.key));
    }
    auto alternatives = known;
    std::erase_if(alternatives, [&](const std::string& key) { return refines(section.path, key); });
    if (section.members != Section::Members::any && good.empty() && !unknown)
      reading_.problems.add(
          node.place, section.path, node.members.empty() ? "is empty" : "is incomplete",
          (section.members == Section::Members::atLeastOne ? "needs at least one of " : "needs one of ") +
              join(alternatives));
    if (good.size() > 1) std::erase_if(good, [&](const Member* m) { return joins(section.path, m->key); });
    if (section.members == Section::Members::exactlyOne && good.size() > 1)
      reading_.problems.add(good[1]->place, inside(section.path, good[1]->key), "stands beside " + good[0]->key,
                            "give one of " + join(alternatives, " or "));
  }

  const Node& root_;
  Scenario& scenario_;
  Reading& reading_;
};

}  // namespace

void readTable(const Node& root, Scenario& scenario, Reading& reading) {
  TableReader(root, scenario, reading).read(*parameterTable().section(""), root);
}

const Section* ParameterTable::section(std::string_view path) const {
  for (const auto& s : sections)
    if (s.path == path) return &s;
  return nullptr;
}

const Parameter* ParameterTable::parameter(std::string_view path) const {
  for (const auto& p : parameters)
    if (p.path == path) return &p;
  return nullptr;
}

std::vector<const Parameter*> ParameterTable::parametersOf(std::string_view section) const {
  std::vector<const Parameter*> found;
  for (const auto& p : parameters)
    if (p.parent() == section) found.push_back(&p);
  return found;
}

std::vector<const Section*> ParameterTable::sectionsOf(std::string_view section) const {
  std::vector<const Section*> found;
  for (const auto& s : sections)
    if (!s.path.empty() && s.parent() == section) found.push_back(&s);
  return found;
}

Scenario allDefaults() {
  Scenario scenario;
  for (const auto& section : parameterTable().sections)
    if (section.make && section.members != Section::Members::exactlyOne) section.make(scenario);
  scenario.scene.mechanics->physics.shell.emplace();
  return scenario;
}

}  // namespace morula::scenario
