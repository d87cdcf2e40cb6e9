#pragma once
// Scenario files, read strictly.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "values/scenario_data.h"

namespace morula {

/// One `--set path=value`, with the value as a file would spell it.
struct Override {
  std::string path;      // physics.time_step
  std::string value;     // 0.001, auto, {sphere: 1}, …
  std::string place;     // name of the option in messages: "--set physics.time_step", "--seed"
  bool removes = false;  // the path is removed from the file
};

/// Reads `--set path=value`; null or ~ for the value removes. Throws InputError without a path or '='.
Override parseOverride(const std::string& text);

/// Reads, overrides and checks a scenario file. Throws InputError with one line per mistake, all of them at once,
/// sorted by line: `file:line:column: path: what is wrong; what would be right`. Throws FileError if the file cannot be
/// read. Files that the scenario names must lie in its folder, or below its folder `scenarios`, unless `allowOutside`.
Scenario loadScenario(const std::filesystem::path& file, const std::vector<Override>& overrides = {},
                      bool allowOutside = false);

/// Returns the scenario as if it had been read with that seed.
Scenario withSeed(Scenario scenario, std::uint64_t seed);

/// Computes `resolved`, `meaning` and `referenceMeaning` anew, after any of the scenario's values was changed.
void resolveAgain(Scenario& scenario);

/// Returns the folder whose files a scenario or a study may name: its own, or the folder `scenarios` around it, whose
/// scenarios share DNA and meshes.
std::filesystem::path sharedFolder(const std::filesystem::path& folder);

/// Returns the folder in which a scenario's files are looked for; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

/// Reads a scenario from a text in memory. Messages call it `name`. Files that it mentions come from `files`, by role,
/// or else from `folder`; with "" from `files` alone.
Scenario readScenario(const std::string& bytes, const std::string& name, const std::filesystem::path& folder,
                      const std::vector<Override>& overrides = {}, const std::vector<NamedFile>& files = {},
                      bool allowOutside = false);

/// Returns the entry of the scenario's `colours` for a substance: its own, or else the longest pattern that fits; null
/// if there is none.
const std::pair<const std::string, std::string>* colourEntryOf(const Scenario& scenario, const std::string& substance);
/// Returns the colour of a cell itself, of the smallest clone or of the generation that it belongs to; null if the
/// scenario has none for it.
const CellColour* cellColourOf(const Scenario& scenario, const CellPath& cell);
/// Returns the colour of `colourEntryOf`, if there is one.
std::optional<std::string> colourOf(const Scenario& scenario, const std::string& substance);

}  // namespace morula
