#pragma once
// Scenario files, read strictly.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "values/scenario_data.h"

namespace morula {

/// One `--set path=value`. The value is what would stand in the file.
struct Override {
  std::string path;      // physics.time_step
  std::string value;     // 0.001, auto, {sphere: 1}, …
  std::string place;     // how messages name it: "--set physics.time_step", "--seed"
  bool removes = false;  // what stands there in the file is taken away
};

/// Reads `--set path=value`; null or ~ for the value removes. Throws InputError without a path or '='.
Override parseOverride(const std::string& text);

/// Reads, overrides and checks a scenario file. Throws InputError with one line per mistake, all of them at once,
/// sorted by line: `file:line:column: path: what is wrong; what would be right`. Throws FileError if the file cannot be
/// read. Files that it names must lie in its folder, or with it below a folder `scenarios`, unless `allowOutside`.
Scenario loadScenario(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
                      bool allowOutside = false);

/// The scenario as if it had been read with that seed.
Scenario withSeed(Scenario scenario, std::uint64_t seed);

/// Computes `resolved`, `meaning` and `referenceMeaning` anew, after any of the scenario's values was changed.
void resolveAgain(Scenario& scenario);

/// The folder whose files a scenario or a study may name: its own, or the folder `scenarios` that it lies in, whose
/// scenarios share DNA and meshes.
std::filesystem::path sharedFolder(const std::filesystem::path& folder);

/// The folder that a scenario's files are looked for in; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Reads a scenario from a text in memory. Messages call it `name`; the files that it mentions are those among
/// `files`, by role, or else looked for in `folder`; with "" nowhere.
Scenario readScenario(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                      const std::vector<Override>& overrides = {}, const std::vector<NamedFile>& files = {},
                      bool allowOutside = false);

/// The entry of the scenario's `colours` that a substance goes by: its own, or else the longest fitting
/// pattern; null if there is none.
const std::pair<const std::string, std::string>* colourEntryOf(const Scenario& scenario, const std::string& substance);
/// Its colour.
std::optional<std::string> colourOf(const Scenario& scenario, const std::string& substance);

}  // namespace morula
