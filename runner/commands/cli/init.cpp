// morula init: a scenario, a DNA or a study to begin with.
#include <filesystem>

#include "base/error.h"
#include "biology/full_tree.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "scenario/schema.h"
#include "study/study_file.h"
#include "study/study_schema.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct InitOptions {
  std::string file, output, dna, study, base = "my-organism.yaml";
  int levels = 10;
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

int act(const InitOptions& options) {
  const auto file = options.file + options.output;
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
  Verb verb(app, action, "init", "Write a commented scenario, study or DNA to begin with");
  auto& options = verb.does<InitOptions>(act);
  verb.takes("file", options.file, "FILE", "File to write; default: standard output");
  verb.takes("-o,--output", options.output, "FILE", "File to write, as FILE");
  verb.takes("--dna", options.dna, "NAME", readDnaKind,
             "Write DNA instead of a scenario; full-tree: every cell divides, all leaves differ");
  verb.takes("--levels", options.levels, "N", natural(1, 16),
             "Divisions from the egg to the leaves of the full tree, 1 to 16");
  verb.takes("--study", options.study, "NAME", "Write a study of this name instead of a scenario");
  verb.takes("--base", options.base, "FILE", "The scenario that the study varies, from the study's folder");
  verb.oneOf({"file", "--output"});
  verb.oneOf({"--dna", "--study"});
  verb.onlyWith({"--levels"}, {"--dna"});
  verb.onlyWith({"--base"}, {"--study"});
  verb.takes("--force", options.force, "Replace an existing file");
}

}  // namespace morula::cli
