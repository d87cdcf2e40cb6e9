#include "scenario/loading.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

/// Returns all of a section; with `defaults`, only what decides results. Parameters that joined the format later then
/// count only if they differ from `defaults`, so that new ones leave all hashes as they are.
Json resolveSection(const Section& section, const Scenario& scenario, const Scenario* defaults) {
  if (section.entries) return section.entries->write(scenario);
  Json map = Json::object();
  for (const auto* parameter : parameterTable().parametersOf(section.path)) {
    if (defaults && parameter->decides == Decides::presentation) continue;
    auto value = parameter->write(scenario);
    if (value.is_null() || (defaults && parameter->later && value == parameter->write(*defaults))) continue;
    map[parameter->key()] = std::move(value);
  }
  for (const auto* child : parameterTable().sectionsOf(section.path)) {
    if (!child->existsIn(scenario) || (defaults && child->decides == Decides::presentation)) continue;
    auto inner = resolveSection(*child, scenario, defaults);
    if (!defaults || !child->later || !inner.empty()) map[child->key()] = std::move(inner);
  }
  if (!defaults)  // the default of a key that refines an absent one would be refused where the text is read again
    for (const auto* parameter : parameterTable().parametersOf(section.path))
      if (!parameter->needs.empty() && !map.contains(parameter->needs)) map.erase(parameter->key());
  return map;
}

void hash(const Json& value, Hasher& hasher) {
  if (value.is_object()) {
    hasher.add("map").add(std::uint64_t{value.size()});
    for (const auto& [key, member] : value.items()) {
      hasher.field(key);
      hash(member, hasher);
    }
  } else if (value.is_array()) {
    hasher.add("list").add(std::uint64_t{value.size()});
    for (const auto& item : value) hash(item, hasher);
  } else if (value.is_number_float()) {
    hasher.add("real").add(value.get<double>());
  } else if (value.is_number()) {
    hasher.add("natural").add(value.get<std::uint64_t>());
  } else {
    hasher.add("text").add(value.get_ref<const std::string&>());
  }
}

void addMesh(Hasher& hasher, const Mesh& mesh) {
  hasher.add(std::uint64_t{mesh.vertices.size()});
  for (const auto& v : mesh.vertices) hasher.add(v.x).add(v.y).add(v.z);
  for (const auto& face : mesh.faces)
    for (const auto corner : face) hasher.add(corner);
}

void write(const Json& value, const std::string& indent, std::string& out) {
  const auto inner = indent + "  ";
  if (value.is_object() && !value.empty()) {
    out += "{";
    bool first = true;
    for (const auto& [key, member] : value.items()) {
      out += (first ? "\n" : ",\n") + inner + jsonText(key) + ": ";
      write(member, inner, out);
      first = false;
    }
    out += "\n" + indent + "}";
  } else if (value.is_array() && !value.empty()) {
    out += "[";
    for (std::size_t i = 0; i < value.size(); ++i) {
      out += i ? ", " : "";
      write(value[i], inner, out);
    }
    out += "]";
  } else if (value.is_number_float()) {
    out += exactText(value.get<double>());
  } else {
    out += jsonText(value);
  }
}

}  // namespace

Json resolve(const Scenario& scenario) { return resolveSection(*parameterTable().section(""), scenario, nullptr); }

Json resolveMeaning(const Scenario& scenario) {
  const Scenario defaults = allDefaults();
  return resolveSection(*parameterTable().section(""), scenario, &defaults);
}

Hash hashMeaning(const Scenario& scenario) {
  Hasher hasher;
  hash(resolveMeaning(scenario), hasher);
  if (scenario.scene.mechanics) {
    const auto& mesh = scenario.scene.mechanics->mesh;
    addMesh(hasher.field("mesh"), mesh);
    const auto& shell = scenario.scene.mechanics->physics.shell;
    if (shell && shell->mesh) addMesh(hasher.field("shell mesh"), shell->mesh->mesh);
  }
  return hasher.digest();
}

void addReference(Hasher& hasher, const Scenario& scenario) {
  const auto& reference = scenario.check.reference;
  if (!reference) return;
  hasher.field("contacts").add(std::uint64_t{reference->contacts.size()});
  for (const auto& [a, b] : reference->contacts) hasher.add(a.text()).add(b.text());
  hasher.field("positions").add(std::uint64_t{reference->positions.size()});
  for (const auto& [path, x] : reference->positions) hasher.add(path.text()).add(x.x).add(x.y).add(x.z);
}

std::string writeJson(const Json& value) {
  std::string text;
  write(value, "", text);
  return text + "\n";
}

}  // namespace morula::scenario
