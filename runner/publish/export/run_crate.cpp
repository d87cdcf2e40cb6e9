#include "export/run_crate.h"

#include <fmt/format.h>

#include "base/error.h"
#include "files/content.h"
#include "files/folders.h"
#include "files/printable.h"
#include "golden/accept.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

CrateFile crateFile(const SourceText& d) {
  using Role = CrateFile::Role;
  const auto made = [&](const std::string& path, Role role, const char* description) {
    return CrateFile{.path = path, .role = role, .description = description, .content = d.content};
  };
  if (d.role == "resolved")
    return made("scenario/resolved.json", Role::object, "The scenario with all defaults and changes filled in");
  if (d.role == "diff") return made("program.diff", Role::about, "Changes of the program's sources since their commit");
  if (d.role == "faces")
    return made("faces/" + safeName(d.path, "mesh") + ".bin", Role::about,
                "Faces of the surfaces in run.db: three corners a face, little-endian, 16 bits each up to 65536 "
                "vertices, else 32");
  // Role and path come from the database, which may be a stranger's, so they are made safe.
  const std::string role = safeName(d.role, "document");
  return {role + "/" + safeName(d.path, role), Role::object, describeRole(d.role), d.path, d.content};
}

/// Adds the run's golden file, if it lies below the current folder. The database names the scenario's place, and must
/// not reach other files.
void addGolden(std::vector<CrateFile>& files) {
  for (const CrateFile& file : files) {
    if (!file.path.starts_with("scenario/") || file.alternateName.empty()) continue;
    const fs::path golden = goldenPath(file.alternateName);
    if (!liesWithin(golden, currentFolder()) || contentOfFile(golden) != Content::golden) return;
    files.push_back({"golden/" + safeName(golden.string(), "golden"), CrateFile::Role::object,
                     "The accepted result with which the run is compared", golden.string(), "", golden});
    return;
  }
}

/// Adds the pictures that `morula run` draws. The database does not hold their place; they lie beside a database of one
/// run.
void addPictures(std::vector<CrateFile>& files, const fs::path& folder) {
  const auto add = [&](const fs::path& picture, const std::string& description) {
    const auto inCrate = (picture.parent_path() / safeName(picture.string(), "picture")).generic_string();
    if (isPlainFile(folder / picture) && contentOfFile(folder / picture) == Content::picture)
      files.push_back({"pictures/" + inCrate, CrateFile::Role::result, description, (folder / picture).string(), "",
                       folder / picture});
  };
  add("organism.png", "The organism at the end");
  add("wireframe.png", "The organism at the end, as meshes");
  add("lineage.png", "The tree of the organism's cells");
  if (!isFolder(folder / "sequence")) return;
  for (const fs::path& frame : namesIn(folder / "sequence"))
    if (frame.extension() == ".png") add("sequence" / frame, "The organism on the way");
}

}  // namespace

const char* describeRole(const std::string& role) {
  return role == "dna"         ? "The genes that the scenario names"
         : role == "mesh"      ? "The egg's mesh that the scenario names"
         : role == "shell"     ? "The egg shell's mesh that the scenario names"
         : role == "cells"     ? "The table of cells that the scenario begins with"
         : role == "names"     ? "The names of cells that the scenario names"
         : role == "reference" ? "Reference with which the scenario compares the organism"
                               : "The scenario as it was read";
}

Crate crateOf(Store& store, const StoredRun& run, const std::string& pictures, const fs::path& folder) {
  Crate crate{.name = fmt::format("{}, seed {}: a run of Morula", run.record.scenario, run.record.seed),
              .description = fmt::format("Run {} of the scenario {}: {}, {} cells at time {} after {} steps. State {}.",
                                         run.id, run.record.scenario, name(run.status), run.cells, run.time, run.steps,
                                         run.stateHash.empty() ? "unknown" : run.stateHash),
              .run = run,
              .action = {.name = fmt::format("{}, seed {}", run.record.scenario, run.record.seed),
                         .identifier = run.id,
                         .command = run.record.command,
                         .started = run.started,
                         .ended = run.ended,
                         .status = run.status,
                         .error = run.status == RunStatus::failed   ? run.failure
                                  : run.status == RunStatus::killed ? "stopped by a signal"
                                                                    : "",
                         .parameters = {{"seed", std::to_string(run.record.seed)}},
                         .results = {{"state hash", run.stateHash}}},
              .agent = "",
              .license = "",
              .files = {}};
  for (const SourceText& document : store.documents(run.id)) crate.files.push_back(crateFile(document));
  addGolden(crate.files);
  if (!pictures.empty() && !isFolder(pictures)) throw FileError("'" + pictures + "': no such folder");
  store.copyRun(run.id, folder / "run.db");
  crate.files.push_back(
      {"run.db", CrateFile::Role::result, "All results of the run, in SQLite", store.file().string(), "", {}, true});
  if (!pictures.empty()) addPictures(crate.files, pictures);
  else if (store.runs().size() == 1) addPictures(crate.files, store.file().parent_path());
  return crate;
}

}  // namespace morula
