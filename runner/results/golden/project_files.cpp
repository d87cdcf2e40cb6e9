#include "golden/project_files.h"

#include <algorithm>
#include <set>
#include <string>

#include "files/folders.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

std::string inSmallLetters(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return c < 0x80 ? char(std::tolower(c)) : char(c); });
  return text;
}

}  // namespace

ProjectFiles projectFiles(const fs::path& scenarioFolder) {
  ProjectFiles found;
  for (const fs::path& file : everyFileBelow(scenarioFolder)) {
    const std::string name = inSmallLetters(file.filename().string());
    if (!name.ends_with(".yaml") && !name.ends_with(".yml")) continue;
    const bool isStudy = name.ends_with(".study.yaml") || name.ends_with(".study.yml");
    (isStudy ? found.studies : found.scenarios).push_back(file);
  }
  return found;
}

std::vector<fs::path> goldensWithoutScenario(const fs::path& goldenFolder, const fs::path& scenarioFolder) {
  std::vector<fs::path> orphans;
  if (!fileExists(goldenFolder)) return orphans;
  std::set<fs::path> goldens;  // goldens of scenarios, as paths below `goldenFolder`
  for (fs::path file : projectFiles(scenarioFolder).scenarios)
    goldens.insert(file.lexically_relative(scenarioFolder).replace_extension(".golden"));
  for (const fs::path& golden : everyFileBelow(goldenFolder)) {
    const fs::path name = golden.lexically_relative(goldenFolder);
    if (golden.extension() != ".golden" || *name.begin() == ".pending") continue;
    if (!goldens.contains(name)) orphans.push_back(golden);
  }
  return orphans;
}

}  // namespace morula
