#include "analysis/organisms.h"

#include <fmt/format.h>

#include "comparison/comparison.h"
#include "database/store_error.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "pictures/pictures.h"
#include "system/usage_error.h"

namespace morula {

namespace {

constexpr int side = 420;              // [pixel] of a tile
constexpr std::size_t most = 19 * 19;  // tiles, so that no side exceeds 8192 pixels

/// The first seed that has a finished run.
std::optional<std::size_t> firstDone(const StudyResults& results, const ResultCondition& condition) {
  for (std::size_t s = 0; s < condition.tasks.size(); ++s)
    if (const std::size_t t = condition.tasks[s]; t != noTask && results.tasks[t].status == "done") return s;
  return std::nullopt;
}

OrganismPicture organismOf(const ResultTask& task, const std::filesystem::path& study, bool quiet) {
  const Scenario scenario = storedScenario(study.string(), task.runId);
  if (!scenario.scene.mechanics)
    throw UsageError("--organisms: " + scenario.scene.name + " has no bodies, and nothing can be seen of it");
  Progress progress(scenario.scene.name, quiet);
  const auto run = simulate(makeScenarioWorld(scenario, {}), {.nameOf = scenario.names.function()}, progress);
  const std::string hash = run.end.stateHash ? run.end.stateHash->text() : "none";
  if (hash != task.stateHash)
    throw NondeterminismError(study.string() + ": run " + task.runId + " came to the state " +
                                  task.stateHash + " when the study was made, and now comes to " + hash +
                                  "; was it made by another build?",
                              task.runId, task.stateHash, hash);
  return pictureOf(run.world, scenario);
}

}  // namespace

Drawing drawOrganisms(const StudyResults& results, const std::filesystem::path& study, bool quiet) {
  if (results.conditions.size() > most)
    throw UsageError(
        fmt::format("--organisms: {} conditions are too many for one picture; it has room for {}",
                    results.conditions.size(), most));
  std::vector<OrganismPicture> pictures;
  for (const ResultCondition& condition : results.conditions) {
    const auto seed = firstDone(results, condition);
    OrganismPicture picture;
    if (seed) picture = organismOf(results.tasks[condition.tasks[*seed]], study, quiet);
    picture.title = results.nameOf(condition);
    picture.caption =
        seed ? fmt::format("seed {}, {}", results.seeds[*seed], picture.caption) : "no finished run";
    picture.legend.clear();
    picture.width = picture.height = side;
    pictures.push_back(std::move(picture));
  }
  const Framing framing = fitFraming(pictures);
  std::vector<Image> tiles;
  for (OrganismPicture& picture : pictures) {
    picture.camera.framing = framing;
    tiles.push_back(drawOrganism(picture));
  }
  const bool rows = results.axes.size() > 1 && results.axes.back().labels.size() <= 19;
  return contactSheet(tiles, rows ? static_cast<int>(results.axes.back().labels.size()) : 0);
}

}  // namespace morula
