#include "check/pending.h"

#include <algorithm>

#include "base/error.h"
#include "base/hash.h"
#include "check/beside_golden.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "files/write_file.h"
#include "golden/accept.h"
#include "pictures/pictures.h"
#include "simulation/simulation.h"
#include "store/build_info.h"
#include "system/console.h"
#include "system/installation.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

constexpr const char* extensions[] = {".golden", ".png", ".from"};

/// Beside the goldens of the project that the scenario belongs to. What comes with an installation belongs to the
/// project that one stands in.
fs::path pendingFolder(const Scenario& scenario) {
  const auto installed = installation();
  const bool isOurs = installed && liesWithin(scenario.file, *installed);
  return (isOurs ? fs::path("golden") : goldenFolder(scenario.file)) / ".pending";
}

/// The folder that `pending`, a folder .pending, belongs to: with `golden` in it, or the scenarios themselves.
fs::path projectOf(const fs::path& pending) {
  const fs::path folder = absolutePath(pending).parent_path();
  return folder.filename() == "golden" ? folder.parent_path() : folder;
}

/// The scenario's file as seen from its project; from the root where it lies elsewhere, as an installation's do.
std::string placeOf(const Scenario& scenario) {
  const fs::path file = absolutePath(scenario.file),
                 place = file.lexically_relative(projectOf(pendingFolder(scenario)));
  return (place.empty() || *place.begin() == ".." ? file : place).generic_string();
}

/// golden/.pending/thesis/unique-four-1a2b3c4d.golden: a project's own and an installation's scenario may have one
/// name, so a hash of the place follows it.
fs::path fileOf(const Scenario& scenario, const char* extension) {
  return pendingFolder(scenario) /
         (goldenName(scenario.file) + '-' + Hasher().add(placeOf(scenario)).digest().text().substr(0, 8) + extension);
}

void removeAll(fs::path file) {
  for (const char* extension : extensions) removeFile(file.replace_extension(extension));
}

/// The origin of a result: the lines of its .from.
struct Origin {
  std::string scenario, build;
  friend bool operator==(const Origin&, const Origin&) = default;
};

Origin originOf(const Scenario& scenario) { return {placeOf(scenario), buildId(buildInfo())}; }

Origin readOrigin(const fs::path& file) {
  Origin origin;
  if (!fileExists(file)) return origin;
  const std::vector<std::string> lines = linesOf(readFile(file));
  if (lines.size() > 0) origin.scenario = lines[0];
  if (lines.size() > 1) origin.build = lines[1];
  return origin;
}

}  // namespace

fs::path pendingPicture(const Scenario& scenario) { return fileOf(scenario, ".png"); }

void putPending(const Scenario& scenario, const Simulation& run, const GoldenData& observed, const Execution& how,
                bool quiet) {
  const fs::path file = fileOf(scenario, ".golden");
  const Origin origin = originOf(scenario);
  try {
    makeFolder(file.parent_path());
    overwriteFile(pendingFolder(scenario) / ".gitignore", "*\n");
    removeFile(pendingPicture(scenario));  // of an earlier result
    overwriteFile(file, writeGolden({observed, "nobody", "pending", {}}));
    overwriteFile(fileOf(scenario, ".from"), origin.scenario + '\n' + origin.build + '\n');
  } catch (const FileError& error) {
    tellError(std::string(error.what()) + "; so the result is not kept for a review");
    return;
  }
  tell("kept for `" + programWord() + " review " + shellWord(scenario.file) + "`: " + file.string(), quiet);
  if (!run.world.bodies) return;
  const auto beside = drawBesideGoldenFile(scenario, run.world, how, quiet);
  if (!beside) writePicture(drawOrganism(pictureOf(run.world, scenario)), pendingPicture(scenario));
  else writePicture(beside->sheet(), pendingPicture(scenario));
}

std::optional<GoldenData> waitingResult(const Scenario& scenario) {
  const fs::path file = fileOf(scenario, ".golden");
  if (!fileExists(file)) return std::nullopt;
  return readGoldenFile(file).data;
}

fs::path pendingFile(const Scenario& scenario) { return fileOf(scenario, ".golden"); }

std::optional<GoldenData> findPending(const Scenario& scenario) {
  const fs::path file = fileOf(scenario, ".golden");
  if (!fileExists(file) || readOrigin(fileOf(scenario, ".from")) != originOf(scenario)) return std::nullopt;
  GoldenData data = readGoldenFile(file).data;
  if (data.scenarioHash != scenario.meaning.text()) return std::nullopt;
  return data;
}

void removePending(const Scenario& scenario) { removeAll(fileOf(scenario, ".golden")); }

PendingResults pendingResults() {
  PendingResults waiting;
  for (const char* folder : {"golden/.pending", ".pending"}) {  // the second: of scenarios beside their goldens
    if (!fileExists(folder)) continue;
    for (const fs::path& result : filesBelow(folder, ".golden")) {
      const fs::path place = readOrigin(fs::path(result).replace_extension(".from")).scenario;
      const fs::path scenario = projectOf(folder) / place;
      if (place.empty() || !fileExists(scenario)) waiting.gone.push_back(result);
      else waiting.scenarios.push_back(scenario.lexically_proximate(currentFolder()));
    }
  }
  std::sort(waiting.scenarios.begin(), waiting.scenarios.end());
  std::sort(waiting.gone.begin(), waiting.gone.end());
  return waiting;
}

}  // namespace morula
