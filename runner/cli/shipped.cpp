#include "cli/shipped.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"

namespace morula::cli {

std::vector<std::string> shippedScenarios() {
  namespace fs = std::filesystem;
  if (!fs::is_directory("scenarios"))
    throw FileError(
        "there is no folder 'scenarios' here; name the scenario files, or go to the project's folder");
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator("scenarios"))
    if (entry.is_regular_file() && entry.path().extension() == ".yaml")
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace morula::cli
