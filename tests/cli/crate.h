#pragma once
// A strict reader of crates: every file is listed, every listed file is there with its size and hash, and every id that
// is referred to is an entity.
#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "base/hash.h"
#include "launch.h"

namespace morula::test {

using Json = nlohmann::json;
namespace fs = std::filesystem;

inline std::vector<Json> asList(const Json& value) {
  if (value.is_null()) return {};
  return value.is_array() ? value.get<std::vector<Json>>() : std::vector<Json>{value};
}

/// Returns the property's value, null if there is none.
inline Json valueOf(const Json& entity, const char* property) {
  return entity.contains(property) ? entity.at(property) : Json();
}

/// Returns the id that the property {"@id": …} names, or "".
inline std::string idOf(const Json& entity, const char* property) {
  const Json value = valueOf(entity, property);
  return value.is_object() ? value.value("@id", "") : "";
}

inline const Json* find(const Json& document, const std::string& id) {
  for (const Json& entity : document["@graph"])
    if (entity["@id"] == id) return &entity;
  return nullptr;
}

inline std::string decoded(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') text += uri[i];
    else text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)), i += 2;
  }
  return text;
}

/// Collects everything that {"@id": …} refers to, except an entity's own name.
inline void collectReferences(const Json& value, std::vector<std::string>& references) {
  if (value.is_object() && value.size() == 1 && value.contains("@id")) references.push_back(value["@id"]);
  else if (value.is_structured())
    for (const Json& part : value) collectReferences(part, references);
}

/// Returns the crate's mistakes against RO-Crate 1.1 and the Process Run Crate profile 0.5, one line each; "" if there
/// are none. `needsLicense`: a crate without a licence, which is written with a warning, is one, too.
inline std::string mistakes(const Json& document, const std::string& folder, bool needsLicense = false) {
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
  for (const char* property : {"name", "description", "datePublished", "license"})
    demand(root->contains(property) || (property == std::string("license") && !needsLicense),
           std::string("the root's ") + property);
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
      demand(file->value("contentSize", "") == std::to_string(fs::file_size(path)) &&
                 file->value("identifier", "") == "xxh3-128:" + hashOf(readWhole(path)).text(),
             "the size or the hash of " + parts.back());
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

inline bool hasPart(const Json& document, const std::string& id) {
  for (const Json& part : (*find(document, "./"))["hasPart"])
    if (part["@id"] == id) return true;
  return false;
}

}  // namespace morula::test
