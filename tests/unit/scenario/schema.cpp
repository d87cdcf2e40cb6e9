#include "scenario/schema.h"

#include <set>

#include "helpers.h"
#include "scenario/loading.h"

using namespace morula;
using namespace morula::test;

namespace {

/// Adds the paths of all keys that the schema describes.
void collect(const Json& schema, const std::string& at, std::set<std::string>& paths) {
  if (!schema.contains("properties")) return;
  for (const auto& [key, value] : schema["properties"].items()) {
    paths.insert(at + key);
    collect(value, at + key + ".", paths);
  }
}

}  // namespace

TEST_CASE("the schema is JSON and covers exactly the keys of the table") {
  const auto schema = parseJson(scenarioSchema());
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  std::set<std::string> described, known;
  collect(schema, "", described);
  for (const auto& p : scenario::parameterTable().parameters) known.insert(p.path);
  for (const auto& s : scenario::parameterTable().sections)
    if (!s.path.empty()) known.insert(s.path);
  CHECK(described == known);
  CHECK(schema["required"] == Json{"morula", "name", "dna", "stop"});
}

TEST_CASE("every map in the schema is closed and every entry explained") {
  const std::function<void(const Json&)> look = [&](const Json& schema) {
    CHECK(schema.contains("description"));
    if (!schema.contains("properties")) return;
    CHECK(schema["additionalProperties"] == false);
    for (const auto& [key, value] : schema["properties"].items()) {
      INFO(key);
      look(value);
    }
  };
  look(parseJson(scenarioSchema()));
}

TEST_CASE("every choice in the schema is a schema") {
  int choices = 0;
  const std::function<void(const Json&)> look = [&](const Json& json) {
    if (json.is_array())
      for (const Json& item : json) look(item);
    if (!json.is_object()) return;
    for (const auto& [key, value] : json.items()) {
      if (key == "oneOf" || key == "anyOf")
        for (const Json& choice : value) CHECK((++choices && choice.is_object()));
      look(value);
    }
  };
  look(parseJson(scenarioSchema()));
  CHECK(choices > 20);
}

TEST_CASE("ranges, names and defaults stand in the schema") {
  const auto properties = parseJson(scenarioSchema())["properties"];
  const auto& physics = properties["physics"]["properties"];
  CHECK(physics["drag"]["minimum"] == 0);
  CHECK(physics["drag"]["default"] == 0);
  CHECK(physics["cell"]["properties"]["radius"]["exclusiveMinimum"] == 0);
  CHECK(physics["integrator"]["enum"] == Json{"velocity-verlet", "thesis-verlet", "explicit-euler", "symplectic-euler",
                                              "rk4", "xpbd", "quasi-static"});
  CHECK(physics["integrator"]["default"] == "velocity-verlet");
  CHECK(physics["mesh"]["properties"]["icosphere"]["maximum"] == 4);
  CHECK(physics["mesh"]["oneOf"] == parseJson(R"([{"required": ["icosphere"]}, {"required": ["file"]}])"));
  CHECK(physics["mesh"]["dependentRequired"] == parseJson(R"({"coarsen": ["icosphere"]})"));
  CHECK(properties["stop"]["minProperties"] == 1);
  CHECK(!properties["morula"].contains("default"));
  CHECK(physics["membrane"]["properties"]["stiffness"]["default"] == MembraneParameters{}.stiffness);
}

TEST_CASE("scenarios/PARAMETERS.md is current") {
  // After a change run: morula schema --markdown > scenarios/PARAMETERS.md
  CHECK(readText("scenarios/PARAMETERS.md") == scenarioParametersAsMarkdown());
}

TEST_CASE("the starter scenario loads") {
  const auto s = read(starterScenario("my-first"));
  CHECK(s.scene.name == "my-first");
  CHECK(s.scene.mechanics->contact);
}
