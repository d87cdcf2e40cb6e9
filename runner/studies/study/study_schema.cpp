#include "study/study_schema.h"

#include "files/text.h"
#include "study/study_table.h"

namespace morula {

std::string studySchema() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Morula study"},
              {"type", "object"},
              {"description", "Scenarios × policies × seeds, and their measures"},
              {"properties", Json::object()},
              {"required", Json::array()},
              {"additionalProperties", false}};
  for (const study::Key& key : study::keys()) {
    Json value{{"description", key.meaning + (key.absent.empty() ? "" : "; absent: " + key.absent)}};
    value.update(key.schema);
    const auto dot = key.path.find('.');
    if (dot == key.path.npos) {
      if (!key.read)
        value.update({{"properties", Json::object()}, {"additionalProperties", false}, {"minProperties", 1}});
      schema["properties"][key.path] = std::move(value);
    } else {
      schema["properties"][key.path.substr(0, dot)]["properties"][key.path.substr(dot + 1)] = std::move(value);
    }
    if (key.absent.empty()) schema["required"].push_back(key.path);
  }
  return jsonText(schema, 2) + "\n";
}

std::string studyKeysAsMarkdown() {
  std::string text =
      "# Keys of a study\n\n"
      "Written by `morula schema --study --markdown` from the table that studies are read with; do not edit.\n\n"
      "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const study::Key& key : study::keys())
    text += "| `" + key.path + "` | " + markdownCell(key.allowed) + " | " +
            markdownCell(key.absent.empty() ? "**required**" : key.absent) + " | " + markdownCell(key.meaning) + " |\n";
  return text;
}

std::string starterStudy(const std::string& name, const std::string& base) {
  return R"(# A study: scenarios × policies × seeds, and what is measured of them.
# All keys: morula schema --study --markdown; in editors: morula schema --study > study.schema.json
morula-study: 1                # version of this format
name: )" +
         yamlText(name) +
         R"(
summary: How planes of division and connections shape an organism
base: )" +
         yamlText(base) +
         R"(           # a scenario, from this file's folder; or several: [a.yaml, b.yaml]

# Axes: each condition has one label of each, and all combinations are run. A label sets any keys of the scenario, as --set
# does; null takes a part away, and {} leaves the scenario as it is. Seeds change random planes, and what the scenario says
# under variation; a condition with neither is run once.
vary:
  division:
    longest: {division.plane: longest}
    random: {division.plane: random}
  connections:
    none: {connections: null}
    both: {connections.make: at-division, connections.on-division: both}

seeds: 1..10                   # each condition with each of them; or one number, or a list
measures: [sister-contact, sphericity, clone-radius, shell-share of AAA*]  # morula schema --measures lists all; at the end
# measures: {names: [sphericity], when: each-division}               # or over time: also when: {every: 0.5}
keep: {hashes: end, samples: end, pictures: first-seed}
limits: {cpu-per-run: 120}     # [s]
)";
}

}  // namespace morula
