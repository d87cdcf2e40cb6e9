#include "scenario/schema.h"

#include "files/text.h"
#include "scenario/loading.h"

namespace morula {

namespace scenario {

namespace {

std::string description(const Parameter& p) {
  return p.meaning + (p.unit.empty() ? "" : " [" + p.unit + "]") + (p.absent.empty() ? "" : "; absent: " + p.absent);
}

Json parameterSchema(const Parameter& p, const Scenario& defaults) {
  Json schema{{"description", description(p)}};
  schema.update(p.schema);
  if (auto value = p.write(defaults); !p.required && !value.is_null()) schema["default"] = std::move(value);
  return schema;
}

Json sectionSchema(const Section& section, const Scenario& defaults) {
  const auto& table = parameterTable();
  Json schema{{"type", "object"},
              {"description", section.meaning + (section.absent.empty() ? "" : "; absent: " + section.absent)}};
  if (section.entries) {
    schema.update(section.entries->schema);
    return schema;
  }
  Json properties = Json::object(), required = Json::array(), needs = Json::object();
  for (const auto* p : table.parametersOf(section.path)) {
    properties[p->key()] = parameterSchema(*p, defaults);
    if (p->required) required.push_back(p->key());
    if (!p->needs.empty()) needs[p->key()] = Json::array({p->needs});
  }
  for (const auto* child : table.sectionsOf(section.path)) {
    properties[child->key()] = sectionSchema(*child, defaults);
    if (child->required) required.push_back(child->key());
    if (!child->needs.empty()) needs[child->key()] = Json::array({child->needs});
  }
  schema["properties"] = std::move(properties);
  schema["additionalProperties"] = false;
  if (!required.empty()) schema["required"] = std::move(required);
  if (!needs.empty()) schema["dependentRequired"] = std::move(needs);
  if (section.members == Section::Members::atLeastOne) schema["minProperties"] = 1;
  if (section.members == Section::Members::exactlyOne) {
    Json others = Json::array();
    for (const auto* p : table.parametersOf(section.path))
      if (p->needs.empty() && !p->joins && !p->beside) others.push_back({{"required", {p->key()}}});
    schema["oneOf"] = others;
    for (const auto* p : table.parametersOf(section.path))
      if (p->joins) schema["oneOf"].push_back({{"required", {p->key()}}, {"not", {{"anyOf", others}}}});
  }
  return schema;
}

std::string defaultText(const Parameter& p, const Scenario& defaults) {
  if (p.required) return "**required**";
  if (!p.absent.empty() && p.write(defaults).is_null()) return p.absent;
  const auto value = p.write(defaults);
  if (value.is_string()) return value.get<std::string>().empty() ? "none" : value.get<std::string>();
  if (value.empty()) return "none";
  auto text = writeJson(value);
  text.pop_back();
  return text;
}

std::string sectionMarkdown(const Section& section, const Scenario& defaults) {
  const auto& table = parameterTable();
  std::string text = section.path.empty() ? "## The file\n\n" : "## `" + section.path + "`\n\n";
  text += section.meaning + ".";
  if (section.required) text += " Required.";
  if (!section.absent.empty()) text += " Absent: " + section.absent + ".";
  if (!section.needs.empty()) text += " Needs `" + section.needs + "`.";
  if (section.members == Section::Members::exactlyOne) text += " Exactly one of:";
  if (section.members == Section::Members::atLeastOne) text += " At least one of:";
  text += "\n";
  if (!section.details.empty()) text += "\n" + section.details;
  if (const auto parameters = table.parametersOf(section.path); !parameters.empty()) {
    text += "\n| key | value | unit | default | meaning |\n|---|---|---|---|---|\n";
    for (const auto* p : parameters) {
      auto allowed = p->allowed;
      if (const auto unit = " [" + p->unit + "]"; !p->unit.empty())
        if (const auto at = allowed.find(unit); at != allowed.npos) allowed.erase(at, unit.size());
      const auto meaning = p->meaning + (p->needs.empty() ? "" : "; beside `" + p->needs + "`");
      text += "| `" + p->key() + "` | " + markdownCell(allowed) + " | " + p->unit + " | " +
              markdownCell(defaultText(*p, defaults)) + " | " + markdownCell(meaning) + " |\n";
    }
  }
  return text + "\n";
}

}  // namespace

}  // namespace scenario

std::string scenarioSchema() {
  using namespace scenario;
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Morula scenario"}};
  schema.update(sectionSchema(*parameterTable().section(""), allDefaults()));
  return jsonText(schema, 2) + "\n";
}

std::string scenarioParametersAsMarkdown() {
  using namespace scenario;
  const auto defaults = allDefaults();
  std::string text =
      "# Parameters of a scenario\n\n"
      "Written by `morula schema --markdown` from the table that the loader reads with; do not edit.\n"
      "Units are the scene's own: a length, a mass and a time; a force is mass·length/time².\n\n";
  for (const auto& section : parameterTable().sections) text += sectionMarkdown(section, defaults);
  text.pop_back();
  return text;
}

std::string starterScenario(const std::string& name) {
  return R"(# A scenario: an organism, how it grows, and how it is shown.
# All keys: morula schema --markdown; in editors: morula schema > scenario.schema.json
morula: 1                      # version of this format
name: )" +
         name +
         R"(
summary: One cell divides twice into four, two of each kind
seed: 1                        # chooses the random numbers; equal seeds give equal results

# Genes. g1(a1|a0): cells with a0 make a1 in their next cycle. divide and die act on the cell; at a division one
# daughter gets A and the other B. What is not made in a cycle is gone after it.
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(divide|a1)
  g4(left|a1,A)
  g5(right|a1,B)
  g6(left|left)
  g7(right|right)

cycle: {length: 1}             # [time] between cell cycles
stop: {cycles: 5}              # or time, or cells

physics:                       # without this block: the lineage only, without bodies
  time_step: auto              # or a number [time]
  mesh: {icosphere: 2}         # 162 vertices; or {file: shape.obj}
  cell: {radius: 1, mass: 1}
  pressure: {constant: 200, outside: 48}  # at rest constant / volume = outside
  drag: 5                      # the medium slows cells, so that they come to rest
  shell: {ellipsoid: [1.3, 1.1, 0.9], fill: 0.9}  # a shape, of which the egg fills 0.9; or {sphere: 1}; or none
  contact: {}                  # without it cells pass through one another

division: {plane: longest}     # or random, or {axis: [1, 0, 0]}
# connections: {on-division: both, strength: 0.1}  # sisters hold on to one another
variation: {cycle: 0.05, share: 0.02}  # what a seed changes, as standard deviations
# units: {length: µm, per-length: 20, time: min, per-time: 5}  # in which people see lengths and times

colours: {left: '#e41a1c', right: '#377eb8'}
record: {every: 0.25}          # [time] between samples in the database
)";
}

}  // namespace morula
