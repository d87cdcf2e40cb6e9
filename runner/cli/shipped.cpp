#include "cli/shipped.h"

#include "base/error.h"
#include "files/folders.h"

namespace morula::cli {

std::vector<std::string> shippedScenarios() {
  if (!isFolder("scenarios"))
    throw FileError(
        "there is no folder 'scenarios' here; name the scenario files, or go to the project's folder");
  std::vector<std::string> files;
  for (const auto& file : filesBelow("scenarios", ".yaml")) files.push_back(file.string());
  return files;
}

}  // namespace morula::cli
