#include "cli/pending.h"

#include <algorithm>
#include <fstream>

#include "base/error.h"
#include "base/hash.h"
#include "baseline/worker.h"
#include "cli/console.h"
#include "cli/pictures.h"
#include "golden/accept.h"
#include "simulation/world.h"
#include "store/build_info.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

constexpr const char* extensions[] = {".golden", ".png", ".from"};

/// …/build/release/pending for …/build/release/morula.
fs::path pendingFolder() { return fs::path(ownProgram()).parent_path() / "pending"; }

/// pending/thesis/unique-four-1a2b3c4d.golden: names are not unique (other folders, other checkouts), places
/// are, so a hash of the place follows the name.
fs::path fileOf(const Scenario& scenario, const char* extension) {
  const std::string place = fs::absolute(scenario.file).lexically_normal().string();
  return pendingFolder() /
         (goldenName(scenario.file) + '-' + Hasher().add(place).digest().text().substr(0, 8) + extension);
}

void removeAll(fs::path file) {
  std::error_code ignored;
  for (const char* extension : extensions) fs::remove(file.replace_extension(extension), ignored);
}

/// What made a result: the lines of its .from.
struct Origin {
  std::string scenario, build;
  friend bool operator==(const Origin&, const Origin&) = default;
};

Origin originOf(const Scenario& scenario) {
  return {fs::absolute(scenario.file).lexically_normal().string(), buildId(buildInfo())};
}

Origin readOrigin(const fs::path& file) {
  Origin origin;
  std::ifstream lines(file);
  std::getline(lines, origin.scenario);
  std::getline(lines, origin.build);
  return origin;
}

bool write(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  return static_cast<bool>((out << text).flush());
}

}  // namespace

fs::path pendingPicture(const Scenario& scenario) { return fileOf(scenario, ".png"); }

void putPending(const Scenario& scenario, const Simulation& run, const GoldenData& observed, bool quiet) {
  const fs::path file = fileOf(scenario, ".golden");
  std::error_code problem;
  fs::create_directories(file.parent_path(), problem);
  const Origin origin = originOf(scenario);
  if (!write(file, writeGolden({observed, "nobody", "pending", {}})) ||
      !write(fileOf(scenario, ".from"), origin.scenario + '\n' + origin.build + '\n')) {
    tell(file.string() + ": cannot be written: the result is not kept for a review", quiet);
    return;
  }
  if (run.world.bodies)
    writePng(drawOrganism(pictureOf(run.world, scenario)), pendingPicture(scenario).string());
  tell("kept for `morula review`: " + file.string(), quiet);
}

std::optional<GoldenData> findPending(const Scenario& scenario) {
  const fs::path file = fileOf(scenario, ".golden");
  if (!fs::exists(file) || readOrigin(fileOf(scenario, ".from")) != originOf(scenario)) return std::nullopt;
  GoldenData data = readGoldenFile(file).data;
  if (data.scenarioHash != scenario.meaning.text()) return std::nullopt;
  return data;
}

void removePending(const Scenario& scenario) { removeAll(fileOf(scenario, ".golden")); }

std::vector<fs::path> pendingScenarios() {
  std::vector<fs::path> waiting, scenarios;
  if (!fs::exists(pendingFolder())) return scenarios;
  for (const auto& entry : fs::recursive_directory_iterator(pendingFolder()))
    if (entry.path().extension() == ".golden") waiting.push_back(entry.path());
  for (const fs::path& result : waiting) {
    const fs::path scenario = readOrigin(fs::path(result).replace_extension(".from")).scenario;
    if (scenario.empty() || !fs::exists(scenario)) removeAll(result);
    else scenarios.push_back(scenario.lexically_proximate(fs::current_path()));
  }
  std::sort(scenarios.begin(), scenarios.end());
  return scenarios;
}

}  // namespace morula::cli
