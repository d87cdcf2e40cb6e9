// morula init: something to begin with.
#include <filesystem>
#include <memory>

#include "base/error.h"
#include "biology/full_tree.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "files/write_file.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "scenario/schema.h"
#include "study/study_schema.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct InitOptions {
  std::string file, output, dna, study, base, levels = "10";
  bool force = false;
};

/// To a file, or to stdout without one.
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

int act(const InitOptions& options) {
  if (!options.file.empty() && !options.output.empty()) throw UsageError("FILE and -o: give one of them");
  const auto file = options.file + options.output;
  if (options.dna == "full-tree")
    return write(makeFullTreeDna(static_cast<int>(naturalOption("--levels", options.levels, 1, 16))), file,
                 options.force);
  if (!options.dna.empty() && !options.study.empty()) throw UsageError("--dna and --study: give one of them");
  if (!options.dna.empty()) throw UsageError("--dna: '" + options.dna + "' is not known; needs full-tree");
  if (options.study.empty() && !options.base.empty()) throw UsageError("--base belongs to --study");
  if (!options.study.empty())
    return write(starterStudy(options.study, options.base.empty() ? "my-organism.yaml" : options.base), file,
                 options.force);
  std::string name = std::filesystem::path(file).stem().string();
  for (auto& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '-';
  return write(starterScenario(name.empty() || name[0] == '-' ? "my-organism" : name), file, options.force);
}

}  // namespace

void addInit(CLI::App& app, Action& action) {
  auto options = std::make_shared<InitOptions>();
  Verb verb(app, action, "init", "Write a commented scenario, study or DNA to begin with");
  verb.takes("file", options->file, "FILE", "Where to; default: standard output");
  verb.takes("-o,--output", options->output, "FILE", "The same");
  verb.takes("--dna", options->dna, "NAME",
             "DNA instead of a scenario; full-tree: every cell divides, all leaves differ");
  verb.takes("--levels", options->levels, "N",
             "Divisions from the egg to the leaves of the full tree, 1 to 16");
  verb.takes("--study", options->study, "NAME", "A study of this name instead of a scenario");
  verb.takes("--base", options->base, "FILE",
             "The scenario that the study varies, from the study's folder; default: my-organism.yaml");
  verb.takes("--force", options->force, "Write over a file that is there");
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli
