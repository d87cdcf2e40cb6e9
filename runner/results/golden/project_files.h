#pragma once
// The files below a project's folders `scenarios` and `golden`.
#include <filesystem>
#include <vector>

namespace morula {

/// The files below a folder `scenarios` that end in .yaml or .yml, in capitals or not, links to folders followed.
struct ProjectFiles {
  std::vector<std::filesystem::path> scenarios;  // sorted
  std::vector<std::filesystem::path> studies;    // those that end in .study.yaml or .study.yml, sorted
};

/// Throws FileError if there is no such folder.
ProjectFiles projectFiles(const std::filesystem::path& scenarioFolder);

/// Golden files under `goldenFolder` that have no scenario under `scenarioFolder`, sorted; none if there is no such
/// folder. Results that wait for a review are not among them.
std::vector<std::filesystem::path> goldensWithoutScenario(const std::filesystem::path& goldenFolder,
                                                          const std::filesystem::path& scenarioFolder);

}  // namespace morula
