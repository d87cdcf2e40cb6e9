// morula init: a scenario, a DNA or a study to begin with.
#include <filesystem>

#include "base/error.h"
#include "biology/full_tree.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "scenario/schema.h"
#include "study/study_file.h"
#include "study/study_schema.h"
#include "system/console.h"
#include "system/usage_error.h"
#include "tracks/write_embryo.h"

namespace morula::cli {
namespace {

struct InitOptions {
  std::string file, output, dna, study, base = "my-organism.yaml";
  int levels = 10;
  std::string from;
  tracks::EmbryoOptions embryo;
  bool force = false;
};

/// Writes to a file, or to stdout without a file.
int write(const std::string& text, const std::string& file, bool force) {
  if (file.empty()) {
    print(text);
    return fine;
  }
  if (!force && fileExists(file)) throw FileError("'" + file + "' is there already; --force writes over it");
  if (force) overwriteFile(file, text);
  else writeNewFile(file, text);
  tell("wrote " + file, false);
  return fine;
}

std::string readDnaKind(const std::string& text) {
  if (text != "full-tree") throw InputError("'" + text + "' is not known; needs full-tree");
  return text;
}

/// Writes a scenario and its files from a table of tracks: all of them or none.
int writeFromTable(const InitOptions& options, const std::filesystem::path& scenario) {
  if (!scenario.string().ends_with(".yaml"))
    throw UsageError("--from writes several files: name the scenario, as embryo.yaml");
  std::vector<std::string> assumed;
  const auto files = tracks::embryoFromTable(readFile(options.from, maxTableBytes), options.from, options.embryo,
                                             scenario.stem().string(), assumed);
  const auto pathOf = [&](const tracks::EmbryoFile& file) { return scenario.parent_path() / file.path; };
  for (const auto& file : files)
    if (!options.force && fileExists(pathOf(file)))
      throw FileError("'" + pathOf(file).string() +
                      "' is there already; --force writes over it, and a folder of its own, as " +
                      (scenario.stem() / scenario.filename()).string() + ", keeps it");
  for (const std::string& sentence : assumed) tell(sentence, false);
  // The scenario comes last: where it is, the files are that it names.
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    makeFolder(pathOf(*file).parent_path());
    overwriteFile(pathOf(*file), file->text);
  }
  tell("wrote " + scenario.string() + " and " + std::to_string(files.size() - 1) + " files that belong to it", false);
  return fine;
}

/// "27,15,14"
std::array<double, 3> readShell(const std::string& text) {
  std::array<double, 3> axes;
  const std::vector<std::string> parts = partsOf(text, ',');
  if (parts.size() != 3) throw InputError("'" + text + "' is no shell; needs three semi-axes, as 27,15,14");
  for (std::size_t i = 0; i < 3; ++i) axes[i] = number(scenario::Range{.low = 1e-30, .high = 1e30})(parts[i]);
  return axes;
}

bool readModel(const std::string& text) {
  if (text != "mesh" && text != "sphere") throw InputError("'" + text + "' is not known; needs mesh or sphere");
  return text == "sphere";
}

int act(const InitOptions& options) {
  const auto file = options.file + options.output;
  if (!options.from.empty()) return writeFromTable(options, file);
  if (!options.dna.empty()) return write(makeFullTreeDna(options.levels), file, options.force);
  // Written files have no mistakes: a name or a base that would cause one is rejected here.
  if (!options.study.empty()) {
    const std::string text = starterStudy(options.study, options.base);
    readStudy(text, file.empty() ? "init --study" : file);
    return write(text, file, options.force);
  }
  std::string name = std::filesystem::path(file).stem().string();
  for (auto& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '-';
  const std::string text = starterScenario(name.empty() || name[0] == '-' ? "my-organism" : name);
  readScenario(text, file.empty() ? "init" : file, "");
  return write(text, file, options.force);
}

}  // namespace

void addInit(CLI::App& app, Action& action) {
  Verb verb(app, action, "init", "Write a commented scenario, study or DNA as a start");
  auto& options = verb.does<InitOptions>(act);
  verb.takes("file", options.file, "FILE", "File to write; default: standard output");
  verb.takes("-o,--output", options.output, "FILE", "File to write, as FILE");
  verb.takes("--dna", options.dna, "NAME", readDnaKind,
             "Write DNA instead of a scenario; full-tree: every cell divides, and all leaves differ");
  verb.takes("--levels", options.levels, "N", natural(1, 16),
             "Divisions from the egg to the leaves of the full tree, 1 to 16");
  verb.takes("--study", options.study, "NAME", "Write a study of this name instead of a scenario");
  verb.takes("--base", options.base, "FILE", "The scenario that the study varies, from the study's folder");
  verb.takes(
      "--from", options.from, "TABLE",
      "Write the scenario of tracked cells: CSV with a row per cell and frame (track_id, t, z, y, x, "
      "parent_track_id; name, volume or radius) or a row per cell (cell, parent, birth, division), or man_track.txt");
  verb.takes("--units", options.embryo.units, "LENGTH,TIME", readUnits,
             "Units of the table, as µm,min; with factors, as 0.5µm,2min");
  verb.takes("--columns", options.embryo.columns, "NAME=HEADER", readColumns,
             "Headers of the table's columns, as x=POSITION_X,name=CELL");
  verb.takes("--shell", options.embryo.shell, "X,Y,Z", readShell,
             "Semi-axes of the shell along x, y and z, in the table's unit; default: fitted to the cells");
  verb.takes("--root", options.embryo.root, "CELL", "Take only this cell of the table and its descendants");
  verb.takes("--model", options.embryo.areSpheres, "NAME", readModel,
             "Bodies of cells: mesh, or sphere, which is faster and coarser");
  verb.showDefault("--model", "mesh");
  verb.takes("--per-time", options.embryo.perTime, "TIME", number(scenario::Range{.low = 1e-30, .high = 1e30}),
             "How many of the table's times one of the scenario's is; default: so that a median life is about 4");
  verb.takes("--set", options.embryo.settings, "PATH=VALUE",
             "Write a setting into the scenario, as physics.drag=5; null removes it; may repeat");
  verb.oneOf({"file", "--output"});
  verb.oneOf({"--dna", "--study", "--from"});
  verb.onlyWith({"--units", "--columns", "--shell", "--root", "--model", "--per-time", "--set"}, {"--from"});
  verb.onlyWith({"--levels"}, {"--dna"});
  verb.onlyWith({"--base"}, {"--study"});
  verb.takes("--force", options.force, "Replace an existing file");
}

}  // namespace morula::cli
