#pragma once
// The files below a project's folders `scenarios` and `golden`.
#include <filesystem>
#include <vector>

namespace morula {

/// The files *.yaml and *.yml, in upper or lower case, below a folder `scenarios`. Links to folders are followed.
struct ProjectFiles {
  std::vector<std::filesystem::path> scenarios;  // sorted
  std::vector<std::filesystem::path> studies;    // files that end in .study.yaml or .study.yml, sorted
};

/// Finds the files. Throws FileError if there is no such folder.
ProjectFiles projectFiles(const std::filesystem::path& scenarioFolder);

/// Returns golden files under `goldenFolder` that have no scenario under `scenarioFolder`, sorted; none if there is no
/// such folder. Results that wait for a review are left out.
std::vector<std::filesystem::path> goldensWithoutScenario(const std::filesystem::path& goldenFolder,
                                                          const std::filesystem::path& scenarioFolder);

}  // namespace morula
