// morula export --ro-crate, checked against the requirements of RO-Crate 1.1 and the Process Run Crate profile 0.5.
#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "catch.h"
#include "launch.h"
#include "store/store.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string sceneOfTwoFiles = R"(morula: 1
name: small
dna: {file: two words.dna}
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
record: {pictures: 1}
)";

/// A database with one run of the scene, and the run's pictures.
struct RunWithPictures {
  TemporaryFolder folder;
  std::string database = folder / "run.db", crate = folder / "crate", id;
  explicit RunWithPictures(const Words& more = {}, int code = 0) {
    writeWhole(folder / "small.yaml", sceneOfTwoFiles);
    writeWhole(folder / "two words.dna", "START: a0\ng1(divide|a0)\n");
    run(more, code);
    for (const char* picture : {"organism.png", "lineage.png"})
      if (fs::exists(folder / "small-0/" + picture))
        fs::copy_file(folder / "small-0/" + picture, folder / picture, fs::copy_options::overwrite_existing);
  }
  void run(const Words& more, int code = 0) {
    const Words words{"run", folder / "small.yaml", "--db", database, "--out", folder.path()};
    id = jsonOf(joined(words, more), code)["run_id"];
  }
  Json exported(const Words& more = {}) {
    succeeds(joined({"export", database, "--ro-crate", crate}, more));
    return Json::parse(readWhole(crate + "/ro-crate-metadata.json"));
  }
};

std::vector<Json> asList(const Json& value) {
  if (value.is_null()) return {};
  return value.is_array() ? value.get<std::vector<Json>>() : std::vector<Json>{value};
}

/// Returns the property's value, null if there is none.
Json valueOf(const Json& entity, const char* property) {
  return entity.contains(property) ? entity.at(property) : Json();
}

/// Returns the id that the property {"@id": …} names, or "".
std::string idOf(const Json& entity, const char* property) {
  const Json value = valueOf(entity, property);
  return value.is_object() ? value.value("@id", "") : "";
}

const Json* find(const Json& document, const std::string& id) {
  for (const Json& entity : document["@graph"])
    if (entity["@id"] == id) return &entity;
  return nullptr;
}

std::string decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') text += uri[i];
    else text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)), i += 2;
  }
  return text;
}

/// Collects everything that {"@id": …} refers to, except an entity's own name.
void collectReferences(const Json& value, std::vector<std::string>& references) {
  if (value.is_object() && value.size() == 1 && value.contains("@id")) references.push_back(value["@id"]);
  else if (value.is_structured())
    for (const Json& part : value) collectReferences(part, references);
}

/// Returns the crate's mistakes, one line each; "" if there are none.
std::string mistakes(const Json& document, const std::string& folder) {
  std::string wrong;
  const auto demand = [&](bool holds, const std::string& what) {
    if (!holds) wrong += what + "\n";
  };
  const std::regex date(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ)");
  const std::vector<Json> contexts = asList(document["@context"]);
  demand(!contexts.empty() && contexts[0] == "https://w3id.org/ro/crate/1.1/context", "the context of RO-Crate 1.1");
  demand(contexts.size() == 2 && contexts[1] == "https://w3id.org/ro/terms/workflow-run/context", "the run terms");
  std::map<std::string, int> ids;
  for (const Json& entity : document["@graph"]) {
    demand(entity.contains("@id") && entity["@id"].is_string(), "an entity without @id");
    demand(entity.contains("@type"), "an entity without @type: " + entity.value("@id", ""));
    if (++ids[entity["@id"]] > 1) demand(false, "twice: " + entity["@id"].get<std::string>());
  }

  const Json* descriptor = find(document, "ro-crate-metadata.json");
  const Json* root = find(document, "./");
  if (!descriptor || !root) return wrong + "no descriptor or root";
  demand((*descriptor)["@type"] == "CreativeWork", "the descriptor's type");
  demand(idOf(*descriptor, "about") == "./", "the descriptor is about the root");
  const std::string crate = idOf(*descriptor, "conformsTo");
  demand(crate == "https://w3id.org/ro/crate/1.1", "the descriptor conforms to RO-Crate 1.1");
  demand((*root)["@type"] == "Dataset", "the root's type");
  for (const char* property : {"name", "description", "datePublished"})
    demand(root->contains(property), std::string("the root's ") + property);
  demand(std::regex_match(root->value("datePublished", ""), date), "the root's date in ISO 8601");
  demand(idOf(*root, "conformsTo") == "https://w3id.org/ro/wfrun/process/0.5", "the root conforms to the profile");
  const Json* profile = find(document, "https://w3id.org/ro/wfrun/process/0.5");
  demand(profile && (*profile)["@type"] == "CreativeWork" && (*profile)["version"] == "0.5", "the profile's entity");

  std::vector<std::string> references;
  for (const Json& entity : document["@graph"])
    for (const auto& [name, value] : entity.items()) collectReferences(value, references);
  for (const std::string& id : references) demand(id == crate || ids.contains(id), "a reference to nothing: " + id);

  std::vector<std::string> parts;
  for (const Json& part : asList(valueOf(*root, "hasPart"))) {
    parts.push_back(part["@id"]);
    const Json* file = find(document, parts.back());
    demand(file && (*file)["@type"] == "File", "not a file: " + parts.back());
    const std::string path = folder + "/" + decoded(parts.back());
    demand(fs::is_regular_file(path), "no such file: " + parts.back());
    if (file && fs::is_regular_file(path))
      demand(file->value("contentSize", "") == std::to_string(fs::file_size(path)), "the size of " + parts.back());
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().filename() == "ro-crate-metadata.json") continue;
    const std::string path = fs::relative(entry.path(), folder).string();
    demand(std::any_of(parts.begin(), parts.end(), [&](const auto& p) { return decoded(p) == path; }),
           "not in hasPart: " + path);
  }

  int actions = 0;
  for (const Json& entity : document["@graph"]) {
    if (entity["@type"] != "CreateAction") continue;
    ++actions;
    demand(idOf(*root, "mentions") == entity["@id"], "the root mentions the action");
    for (const char* property : {"name", "description", "instrument", "object", "result", "actionStatus"})
      demand(entity.contains(property), std::string("the action's ") + property);
    for (const char* time : {"startTime", "endTime"})
      demand(std::regex_match(entity.value(time, ""), date), std::string("the action's ") + time);
    demand(entity.value("actionStatus", "").starts_with("http://schema.org/"), "the action's status");
    demand(entity.contains("error") == (valueOf(entity, "actionStatus") == "http://schema.org/FailedActionStatus"),
           "an error where it failed, and only there");
    const Json* tool = find(document, idOf(entity, "instrument"));
    demand(tool && (*tool)["@type"] == "SoftwareApplication", "the instrument is software");
    for (const char* property : {"name", "softwareVersion", "identifier"})
      demand(tool && tool->contains(property), std::string("the software's ") + property);
    demand(tool && !tool->contains("version"), "version and softwareVersion");
    for (const char* list : {"object", "result", "environment"})
      for (const Json& item : asList(valueOf(entity, list))) {
        const Json* thing = find(document, item["@id"]);
        demand(thing && ((*thing)["@type"] == "File" || (*thing)["@type"] == "PropertyValue"),
               std::string(list) + " is neither a file nor a value");
      }
    if (entity.contains("agent")) {
      const Json* agent = find(document, idOf(entity, "agent"));
      demand(agent && (*agent)["@type"] == "Person" && agent->contains("name"), "the agent is a person with a name");
    }
  }
  demand(actions == 1, "one action");
  return wrong;
}

bool hasPart(const Json& document, const std::string& id) {
  for (const Json& part : (*find(document, "./"))["hasPart"])
    if (part["@id"] == id) return true;
  return false;
}

}  // namespace

TEST_CASE("a crate is what RO-Crate 1.1 and the profile require") {
  RunWithPictures stored;
  const Json crate = stored.exported({"--agent", "A. Nother", "--license", "https://spdx.org/licenses/CC0-1.0"});
  CHECK(mistakes(crate, stored.crate) == "");
  for (const char* part : {"run.db", "scenario/small.yaml", "scenario/resolved.json", "dna/two%20words.dna",
                           "pictures/organism.png", "pictures/lineage.png"}) {
    CAPTURE(part);
    CHECK(hasPart(crate, part));
  }
  CHECK(readWhole(stored.crate + "/scenario/small.yaml") == sceneOfTwoFiles);
  CHECK(readWhole(stored.crate + "/pictures/organism.png") == readWhole(stored.folder / "organism.png"));
  const Json& run = *find(crate, "#run");
  CHECK(run["identifier"] == stored.id);
  CHECK(run["actionStatus"] == "http://schema.org/CompletedActionStatus");
  CHECK(run["description"].get<std::string>().starts_with("morula run "));
  CHECK((*find(crate, "#agent"))["name"] == "A. Nother");
}

TEST_CASE("the validator of these tests sees what is wrong") {
  RunWithPictures stored({"--no-pictures"});
  const Json good = stored.exported();
  REQUIRE(mistakes(good, stored.crate) == "");
  const auto without = [&](const std::string& id, const std::string& property) {
    Json bad = good;
    for (Json& entity : bad["@graph"])
      if (entity["@id"] == id) entity.erase(property);
    return mistakes(bad, stored.crate);
  };
  for (const char* property : {"instrument", "endTime", "result", "actionStatus"}) {
    CAPTURE(property);
    CHECK(without("#run", property) != "");
  }
  CHECK(without("./", "datePublished") != "");
  CHECK(without("./", "hasPart") != "");
  CHECK(without("#morula", "softwareVersion") != "");
  Json dangling = good;
  dangling["@graph"].erase(dangling["@graph"].size() - 1);
  CHECK_THAT(mistakes(dangling, stored.crate), ContainsSubstring("a reference to nothing"));
  fs::remove(stored.crate + "/scenario/small.yaml");
  CHECK_THAT(mistakes(good, stored.crate), ContainsSubstring("no such file: scenario/small.yaml"));
}

TEST_CASE("the crate's database holds the exported run alone, and can be replayed") {
  RunWithPictures stored;
  const std::string first = stored.id;
  stored.run({"--seed", "7", "--no-pictures"});
  const Json crate = stored.exported({"--run", first});
  CHECK(mistakes(crate, stored.crate) == "");
  CHECK_FALSE(hasPart(crate, "pictures/organism.png"));  // the run of this picture is unknown
  const auto runs = morula::Store::openForReading(stored.crate + "/run.db").runs();
  REQUIRE(runs.size() == 1);
  CHECK(runs[0].id == first);
  CHECK(morula::Store::openForReading(stored.database).runs().size() == 2);
  CHECK(launch({"replay", stored.crate + "/run.db"}).code == 0);
}

TEST_CASE("a failed run's crate says so, and why") {
  RunWithPictures stored({"--set", "physics.membrane.production=40"}, 4);
  const Json crate = stored.exported();
  CHECK(mistakes(crate, stored.crate) == "");
  CHECK((*find(crate, "#run"))["actionStatus"] == "http://schema.org/FailedActionStatus");
  CHECK_THAT((*find(crate, "#run"))["error"].get<std::string>(), ContainsSubstring("step "));
}

TEST_CASE("without a folder the runs are listed") {
  RunWithPictures stored({"--no-pictures"});
  CHECK_THAT(succeeds({"export", stored.database}).out, ContainsSubstring(stored.id));
  const Json json = jsonOf({"export", stored.database});
  CHECK(json["runs"][0]["run_id"] == stored.id);
  CHECK(json["runs"][0]["status"] == "done");

  // Databases may hold tables of others, with any names.
  change(stored.database, "CREATE TABLE \"a\"\"b\" (\"x\"\"y\" TEXT)");
  CHECK_THAT(succeeds({"export", stored.database, "--list"}).out,
             ContainsSubstring("\n  a\"b ") && ContainsSubstring("which run it is"));
}
