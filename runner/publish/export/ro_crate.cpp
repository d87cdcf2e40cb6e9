#include "export/ro_crate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "base/did_you_mean.h"
#include "base/error.h"
#include "base/hash.h"
#include "files/folders.h"
#include "files/printable.h"
#include "files/read_file.h"
#include "files/write_file.h"
#include "system/json.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

/// Licences of the SPDX list (https://spdx.org/licenses) under which results are published; the newest of a family
/// comes first.
const std::vector<std::string> identifiers{"CC0-1.0",
                                           "CC-BY-4.0",
                                           "CC-BY-SA-4.0",
                                           "CC-BY-NC-4.0",
                                           "CC-BY-NC-SA-4.0",
                                           "CC-BY-ND-4.0",
                                           "CC-BY-NC-ND-4.0",
                                           "CC-BY-3.0",
                                           "CC-BY-SA-3.0",
                                           "CC-PDDC",
                                           "PDDL-1.0",
                                           "ODC-By-1.0",
                                           "ODbL-1.0",
                                           "CDLA-Permissive-2.0",
                                           "CDLA-Sharing-1.0",
                                           "MIT",
                                           "MIT-0",
                                           "0BSD",
                                           "BSD-2-Clause",
                                           "BSD-3-Clause",
                                           "ISC",
                                           "Apache-2.0",
                                           "MPL-2.0",
                                           "EUPL-1.2",
                                           "Unlicense",
                                           "GPL-3.0-or-later",
                                           "GPL-3.0-only",
                                           "GPL-2.0-or-later",
                                           "GPL-2.0-only",
                                           "LGPL-3.0-or-later",
                                           "LGPL-3.0-only",
                                           "LGPL-2.1-or-later",
                                           "LGPL-2.1-only",
                                           "AGPL-3.0-or-later",
                                           "AGPL-3.0-only"};

/// Returns true if `word` is a beginning of an identifier: "CC-BY" or "CC-BY-4" of CC-BY-4.0.
bool begins(const std::string& identifier, const std::string& word) {
  return identifier.size() > word.size() && equalButForCase(identifier.substr(0, word.size()), word) &&
         (identifier[word.size()] == '-' || identifier[word.size()] == '.');
}

std::string probablyMeant(const std::string& word) {
  const auto family =
      std::find_if(identifiers.begin(), identifiers.end(), [&](const std::string& id) { return begins(id, word); });
  return family != identifiers.end() ? *family : closest(word, identifiers);
}

const std::string profile = "https://w3id.org/ro/wfrun/process/0.5";
constexpr std::uint64_t maxCopied = std::uint64_t{1} << 30;
const std::string metadata = "ro-crate-metadata.json";
const std::string action = "#run", instrument = "#morula", agentName = "#agent";

Json reference(const std::string& id) { return {{"@id", id}}; }

/// Returns a path as a relative URI: any byte but letters, digits and -._~/ is written as %XX.
std::string uri(const std::string& path) {
  std::string text;
  for (const unsigned char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~/").find(static_cast<char>(c)) != std::string_view::npos;
    text += plain ? std::string(1, static_cast<char>(c)) : fmt::format("%{:02X}", c);
  }
  return text;
}

bool isUri(const std::string& text) { return text.starts_with("https://") || text.starts_with("http://"); }

std::string encodingFormat(const fs::path& file) {
  const std::string kind = file.extension().string();
  if (kind == ".yaml" || kind == ".yml") return "application/yaml";
  if (kind == ".json") return "application/json";
  if (kind == ".db") return "application/vnd.sqlite3";
  if (kind == ".png") return "image/png";
  if (kind == ".obj") return "model/obj";
  if (kind == ".diff") return "text/x-diff";
  if (kind == ".csv") return "text/csv";
  if (kind == ".svg") return "image/svg+xml";
  if (kind == ".html") return "text/html";
  if (kind == ".md") return "text/markdown";
  if (kind == ".bib") return "application/x-bibtex";
  return "text/plain";
}

/// Returns "xxh3-128:" and 32 hexadecimal digits.
std::string identifierOf(const fs::path& file) {
  Hasher hasher;
  readPieces(file, [&](std::string_view piece) { hasher.addPiece(piece); });
  return "xxh3-128:" + hasher.digest().text();
}

void put(const CrateFile& file, const fs::path& folder) {
  if (file.isThere) return;
  const fs::path target = folder / file.path;
  makeFolder(target.parent_path());
  writeNewFile(target, file.source.empty() ? file.content : readFile(file.source, maxCopied));
}

/// Makes the paths of files distinct: the second "dna/a.dna" becomes "dna/a-2.dna".
void giveEachItsPath(std::vector<CrateFile>& files) {
  std::set<std::string> taken;
  for (CrateFile& file : files) {
    const fs::path path = file.path;
    for (int i = 2; !taken.insert(file.path).second; ++i)
      file.path = (path.parent_path() / (path.stem().string() + "-" + std::to_string(i) + path.extension().string()))
                      .generic_string();
  }
}

/// Entities, and the references to them.
class Graph {
 public:
  Json add(const Json& entity) {
    entities_.push_back(entity);
    return reference(entity.at("@id").get<std::string>());
  }
  /// Adds a named value: one number or text that is in no file.
  Json addValue(const std::string& kind, const std::string& name, const std::string& value) {
    std::string id = "#" + kind + "-" + name;
    std::replace(id.begin(), id.end(), ' ', '-');
    return add({{"@id", id}, {"@type", "PropertyValue"}, {"name", name}, {"value", value}});
  }
  const Json& entities() const { return entities_; }

 private:
  Json entities_ = Json::array();
};

void addProgram(Graph& graph, const StoredRun& run, const Json& about) {
  const RunRecord& r = run.record;
  Json libraries = Json::array(), facts = Json::array();
  for (const auto& [library, version] : r.build.libraries)
    libraries.push_back(graph.add({{"@id", "#library-" + uri(library)},
                                   {"@type", "SoftwareApplication"},
                                   {"name", library},
                                   {"softwareVersion", version}}));
  eachFieldOf(run, [&](const RunField& field, const std::string& value) {
    const std::string_view name = field.name;
    const bool isSaidBelow = name == "build_id" || name == "version" || name == "libraries";
    if ((field.part == RunPart::program || field.part == RunPart::detail) && !isSaidBelow && !value.empty())
      facts.push_back(graph.addValue("build", field.label, value));
  });
  Json program{{"@id", instrument},
               {"@type", "SoftwareApplication"},
               {"name", "Morula"},
               {"description", "A deterministic, scenario-driven simulator of dividing cells"},
               {"softwareVersion", r.build.version},
               {"identifier", buildId(r.build)},
               {"softwareRequirements", libraries},
               {"additionalProperty", facts}};
  if (!about.empty()) program["subjectOf"] = about;
  graph.add(program);
}

Json addConditions(Graph& graph, const StoredRun& run) {
  Json conditions = Json::array();
  eachFieldOf(run, [&](const RunField& field, const std::string& value) {
    if (field.part == RunPart::environment && !value.empty())
      conditions.push_back(graph.addValue("environment", field.label, value));
  });
  return conditions;
}

const char* actionStatus(RunStatus status) {
  if (status == RunStatus::done) return "http://schema.org/CompletedActionStatus";
  if (status == RunStatus::running) return "http://schema.org/ActiveActionStatus";
  return "http://schema.org/FailedActionStatus";
}

Json describeAction(const Crate& crate) {
  const CrateAction& did = crate.action;
  Json json{{"@id", action},
            {"@type", "CreateAction"},
            {"name", did.name},
            {"description", did.command},
            {"identifier", did.identifier},
            {"instrument", reference(instrument)},
            {"startTime", did.started},
            {"actionStatus", actionStatus(did.status)}};
  if (!did.ended.empty()) json["endTime"] = did.ended;
  if (!did.error.empty()) json["error"] = did.error;
  if (!crate.agent.empty()) json["agent"] = reference(isUri(crate.agent) ? crate.agent : agentName);
  return json;
}

Json describeFile(const CrateFile& file, const fs::path& folder) {
  Json json{{"@id", uri(file.path)},
            {"@type", "File"},
            {"name", fs::path(file.path).filename().string()},
            {"description", file.description},
            {"encodingFormat", encodingFormat(file.path)},
            {"contentSize", std::to_string(fileSize(folder / file.path))},
            {"identifier", identifierOf(folder / file.path)}};
  if (!file.alternateName.empty()) json["alternateName"] = file.alternateName;
  return json;
}

Json describeRoot(const Crate& crate, const Json& parts) {
  Json root{{"@id", "./"},
            {"@type", "Dataset"},
            {"conformsTo", reference(profile)},
            {"name", crate.name},
            {"description", crate.description},
            {"datePublished", utcNow()},
            {"mentions", reference(action)},
            {"hasPart", parts}};
  if (!crate.license.empty()) root["license"] = reference(crate.license);
  return root;
}

}  // namespace

void writeCrate(Crate crate, const fs::path& folder) {
  giveEachItsPath(crate.files);
  Graph graph;
  graph.add({{"@id", metadata},
             {"@type", "CreativeWork"},
             {"conformsTo", reference("https://w3id.org/ro/crate/1.1")},
             {"about", reference("./")}});
  Json parts = Json::array(), objects = Json::array(), results = Json::array(), about = Json::array();
  Graph files;
  for (const CrateFile& file : crate.files) {
    put(file, folder);
    parts.push_back(files.add(describeFile(file, folder)));
    auto& list = file.role == CrateFile::Role::object   ? objects
                 : file.role == CrateFile::Role::result ? results
                                                        : about;
    list.push_back(parts.back());
  }
  graph.add(describeRoot(crate, parts));
  graph.add({{"@id", profile}, {"@type", "CreativeWork"}, {"name", "Process Run Crate"}, {"version", "0.5"}});
  addProgram(graph, crate.run, about);
  for (const auto& [name, value] : crate.action.parameters) objects.push_back(graph.addValue("parameter", name, value));
  for (const auto& [name, value] : crate.action.results) results.push_back(graph.addValue("result", name, value));
  Json run = describeAction(crate);
  run["object"] = objects;
  run["result"] = results;
  run["environment"] = addConditions(graph, crate.run);
  graph.add(run);
  if (!crate.agent.empty())
    graph.add({{"@id", isUri(crate.agent) ? crate.agent : agentName}, {"@type", "Person"}, {"name", crate.agent}});
  if (!crate.license.empty()) graph.add({{"@id", crate.license}, {"@type", "CreativeWork"}, {"name", crate.license}});
  for (const Json& file : files.entities()) graph.add(file);

  const Json document{
      {"@context", {"https://w3id.org/ro/crate/1.1/context", "https://w3id.org/ro/terms/workflow-run/context"}},
      {"@graph", graph.entities()}};
  writeNewFile(folder / metadata, printable(jsonText(document, 2)) + "\n");
}

std::vector<std::string> changedFiles(const fs::path& crate) {
  std::map<std::string, std::string> identifiers;  // by id
  try {
    const Json document = parseJson(readFile(crate / metadata));
    for (const Json& entity : document.at("@graph"))
      if (entity.at("@type") == "File") identifiers[entity.at("@id")] = entity.at("identifier");
  } catch (const Json::exception&) {
    throw FileError("'" + (crate / metadata).string() + "' is no crate of `morula study export`; make it anew");
  }
  std::vector<std::string> lines;
  for (const fs::path& file : everyFileBelow(crate)) {
    const std::string path = file.lexically_relative(crate).generic_string();
    if (path == metadata) continue;
    const auto known = identifiers.find(uri(path));
    if (known == identifiers.end()) lines.push_back(path + ": not in " + metadata);
    else if (known->second != identifierOf(file)) lines.push_back(path + ": changed since the crate was made");
    if (known != identifiers.end()) identifiers.erase(known);
  }
  for (const auto& [id, identifier] : identifiers) lines.push_back(id + ": missing");
  return lines;
}

std::string licenseUri(const std::string& license) {
  if (license.empty() || isUri(license)) return license;
  for (const std::string& id : identifiers)
    if (equalButForCase(id, license)) return "https://spdx.org/licenses/" + id;
  const std::string meant = probablyMeant(license);
  throw InputError("'" + license + "' is no SPDX identifier that is known here" +
                   (meant.empty() ? "." : "; did you mean " + meant + "?") +
                   " Give an identifier as CC-BY-4.0 or CC0-1.0, or the licence's address (https://…)");
}

}  // namespace morula
