#include "cli/pending.h"

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "baseline/worker.h"
#include "cli/console.h"
#include "cli/pictures.h"
#include "golden/accept.h"
#include "simulation/world.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

fs::path fileOf(const Scenario& scenario, const char* extension) {
  return pendingFolder() / (goldenName(scenario.file) + extension);
}

}  // namespace

fs::path pendingFolder() { return fs::path(ownProgram()).parent_path() / "pending"; }

fs::path pendingPicture(const Scenario& scenario) { return fileOf(scenario, ".png"); }

void putPending(const Scenario& scenario, const Simulation& run, const GoldenData& observed, bool quiet) {
  const fs::path file = fileOf(scenario, ".golden");
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  std::ofstream out(file, std::ios::binary);
  const Golden pending{observed, "nobody", "pending", {}};
  if (!(out << writeGolden(pending)).flush()) {
    tell(file.string() + ": cannot be written: the result is not kept for a review", quiet);
    return;
  }
  if (run.world.bodies)
    writePng(drawOrganism(pictureOf(run.world, scenario)), pendingPicture(scenario).string());
  tell("kept for `morula review`: " + file.string(), quiet);
}

std::optional<Golden> findPending(const Scenario& scenario) {
  const fs::path file = fileOf(scenario, ".golden");
  if (!fs::exists(file)) return std::nullopt;
  return readGoldenFile(file);
}

void removePending(const Scenario& scenario) {
  std::error_code ignored;
  for (const char* extension : {".golden", ".png"}) fs::remove(fileOf(scenario, extension), ignored);
}

std::vector<std::string> allPending() {
  std::vector<std::string> names;
  if (!fs::exists(pendingFolder())) return names;
  for (const auto& entry : fs::recursive_directory_iterator(pendingFolder()))
    if (entry.path().extension() == ".golden")
      names.push_back(entry.path().lexically_relative(pendingFolder()).replace_extension().generic_string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace morula::cli
