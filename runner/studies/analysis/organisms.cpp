#include "analysis/organisms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/number_text.h"
#include "comparison/organism_grid.h"
#include "database/store_error.h"
#include "document/words.h"
#include "drawing/png_file.h"
#include "files/read_file.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "pictures/pictures.h"
#include "system/signals.h"
#include "system/usage_error.h"
#include "tasks/study_folder.h"

namespace morula {
namespace {

constexpr double rounding = 1e-9;  // [1] rounding error of the last step's end

/// Returns the seed with which the most conditions have a finished run, the first of equals.
std::size_t commonSeed(const StudyResults& results) {
  std::size_t best = 0, most = 0;
  for (std::size_t s = 0; s < results.seeds.size(); ++s) {
    const auto done = static_cast<std::size_t>(
        std::ranges::count_if(results.conditions, [&](const auto& c) { return results.isDone(c.tasks[s]); }));
    if (done > most) best = s, most = done;
  }
  return best;
}

/// A tile, and the values that decide the colours of its cells.
struct TakenTile {
  OrganismTile tile;
  std::vector<std::optional<double>> values = {};
};

/// The observer that takes a tile at each of the times, or for each of the numbers of cells.
class TileTaker : public Observer {
 public:
  TileTaker(const Scenario& scenario, const std::vector<double>& times, const GridMoments& moments)
      : scenario_(scenario), times_(times), moments_(moments) {}

  void see(const World& world) override {
    while (isReached(world))
      take(world, counted(world.cells.path.size(), "cell") +
                      (cells().empty() ? "" : ", time " + shownTime(scenario_.units, world.clock.time)));
  }
  std::uint64_t stepsUntilDue(const World& world) const override {
    return cells().empty() && next() < times_.size() ? stepsUntil(world.clock, times_[next()] * (1 - rounding))
                                                     : neverDue;
  }
  void take(const World& world, const std::string& words) {
    tiles_.push_back({{pictureOf(world, scenario_), false, words}, colourValues(world, moments_.colouring, scenario_)});
    addLabels(tiles_.back().tile.picture, world, scenario_, moments_.labels);
  }
  std::vector<TakenTile>& tiles() { return tiles_; }

 private:
  const std::vector<std::size_t>& cells() const { return moments_.cells; }
  std::size_t next() const { return tiles_.size(); }
  bool isReached(const World& world) const {
    if (!cells().empty()) return next() < cells().size() && world.cells.path.size() >= cells()[next()];
    return next() < times_.size() && world.clock.time >= times_[next()] * (1 - rounding);
  }

  const Scenario& scenario_;
  const std::vector<double>& times_;
  const GridMoments& moments_;
  std::vector<TakenTile> tiles_;
};

/// A tile for each moment that the run reaches, in their order, and for the others; without any, one of the end.
std::vector<TakenTile> tilesOf(const ResultTask& task, const Scenario& scenario, const std::filesystem::path& study,
                               const std::vector<double>& times, const GridMoments& moments, bool quiet) {
  const std::vector<std::size_t>& cells = moments.cells;
  if (!scenario.scene.mechanics)
    throw UsageError("--pictures: " + scenario.scene.name + " has no bodies, so there is nothing to draw");
  const std::size_t wanted = std::max<std::size_t>(1, times.size() + cells.size());
  TileTaker watch(scenario, times, moments);
  const auto run = simulate(scenario, Execution{}, {.quiet = quiet, .watch = {&watch}});
  requireEnough(run.end);
  const std::string hash = run.end.stateHash ? run.end.stateHash->text() : "none";
  if (hash != task.stateHash)
    throw NondeterminismError(study.string() + ": run " + task.runId + " ended in the state " + task.stateHash +
                                  " when the study was made, and now ends in " + hash +
                                  "; check that this build made the study",
                              task.runId, task.stateHash, hash);
  const std::string time = shownTime(scenario.units, run.end.time);
  std::vector<TakenTile>& tiles = watch.tiles();
  if (tiles.size() < wanted) watch.take(run.world, counted(run.end.cells, "cell") + " at the end, time " + time);
  while (tiles.size() < wanted) tiles.push_back({{{}, true, "ended at time " + time}});
  return std::move(tiles);
}

/// Colours all tiles alike, and puts the legend into the grid. Cells have the names of this scenario.
void colourAlike(std::vector<TakenTile>& taken, const Colouring& colouring, const Scenario& scenario,
                 OrganismGrid& grid) {
  std::vector<OrganismPicture> pictures;
  std::vector<std::vector<std::optional<double>>> values;
  for (TakenTile& t : taken)
    if (!t.tile.empty) pictures.push_back(std::move(t.tile.picture)), values.push_back(std::move(t.values));
  colourCells(pictures, values, colouring, scenario);
  std::set<std::string> known;
  for (const OrganismPicture& picture : pictures)
    for (const LegendEntry& entry : picture.legend) {
      if (!entry.shown || !known.insert(entry.label).second) continue;
      const auto same = std::ranges::find(grid.legend, entry.colour, &LegendEntry::colour);
      if (same == grid.legend.end()) grid.legend.push_back(entry);
      else same->label += ", " + entry.label;
    }
  if (!pictures.empty()) grid.colourBar = pictures[0].instruments.colourBar;
  auto next = pictures.begin();
  for (TakenTile& t : taken)
    if (!t.tile.empty) t.tile.picture = std::move(*next++);
}

/// Returns true if pictures that fit their organisms have one scale: all show whole shells of equal size.
bool haveOneScale(const StudyResults& results, std::size_t seed, const std::filesystem::path& study) {
  std::set<std::array<double, 3>> shells;
  for (const ResultCondition& condition : results.conditions) {
    const Scenario scenario = storedScenario(study.string(), results.tasks[condition.tasks[seed]].runId);
    if (!scenario.scene.mechanics) return false;
    const auto& shell = scenario.scene.mechanics->physics.shell;
    if (!shell || shell->mesh) return false;
    shells.insert({shell->semiAxes[0], shell->semiAxes[1], shell->semiAxes[2]});
  }
  return shells.size() == 1;
}

/// Returns true if the levels of the last axis are columns: at the end alone, and in a full design.
bool spreadsLastAxis(const StudyResults& results, const GridMoments& moments) {
  if (moments.count != 1 || !moments.times.empty() || !moments.cells.empty() || results.axes.size() < 2) return false;
  std::size_t all = 1;
  for (const ResultAxis& axis : results.axes) all *= axis.labels.size();
  return all == results.conditions.size() && results.axes.back().labels.size() <= maxGridColumns;
}

std::size_t columnsOf(const StudyResults& results, const GridMoments& moments) {
  if (spreadsLastAxis(results, moments)) return results.axes.back().labels.size();
  if (!moments.times.empty()) return moments.times.size();
  return moments.cells.empty() ? moments.count : moments.cells.size();
}

/// Returns the lines before a row: the labels of its levels in the first `count` axes.
std::vector<std::string> linesOf(const StudyResults& results, const ResultCondition& condition, std::size_t count) {
  std::vector<std::string> lines;
  for (std::size_t axis = 0; axis < count; ++axis) lines.push_back(results.axes[axis].labels[condition.levels[axis]]);
  if (lines.empty()) lines.push_back(results.nameOf(condition));
  return lines;
}

}  // namespace

std::string whyTooMany(const StudyResults& results, const GridMoments& moments) {
  const std::size_t columns = columnsOf(results, moments),
                    rows = results.conditions.size() /
                           (spreadsLastAxis(results, moments) ? std::max<std::size_t>(1, columns) : 1);
  if (columns > maxGridColumns)
    return fmt::format("{} moments are too many for one picture, which has room for {}", columns, maxGridColumns);
  if (rows > maxGridRows)
    return fmt::format("{} conditions are too many for one picture, which has room for {} rows{}",
                       results.conditions.size(), maxGridRows,
                       columns > 1 && !spreadsLastAxis(results, moments) && whyTooMany(results, {1, {}, {}}).empty()
                           ? "; --moments 1 shows the end of each"
                           : "");
  return {};
}

Units unitsOf(const StudyResults& results, const std::filesystem::path& study) {
  const auto axis = std::ranges::find(results.axes, "base", &ResultAxis::name);
  std::map<std::size_t, Units> ofBases;
  for (const ResultCondition& condition : results.conditions) {
    const std::size_t base =
        axis == results.axes.end() ? 0 : condition.levels[static_cast<std::size_t>(axis - results.axes.begin())];
    if (ofBases.contains(base)) continue;
    const auto task = std::ranges::find_if(condition.tasks, [&](std::size_t t) { return results.isDone(t); });
    if (task == condition.tasks.end()) continue;
    try {
      ofBases[base] = storedScenario(study.string(), results.tasks[*task].runId).units;
    } catch (const FileError&) {}  // scenes without stored scenarios keep their own units
  }
  const std::vector<std::pair<std::size_t, Units>> all(ofBases.begin(), ofBases.end());
  return unitsOfAll(all, [](const auto& one) { return one.second; });
}

std::optional<StoredPictures> storedPictures(const StudyResults& results, const std::filesystem::path& study) {
  const StudyFolder folder(study.parent_path());
  for (std::size_t s = 0; s < results.seeds.size(); ++s) {
    StoredPictures stored{.seed = s};
    for (const ResultCondition& condition : results.conditions)
      if (results.isDone(condition.tasks[s]))
        if (auto file = folder.storedPicture(results.tasks[condition.tasks[s]].id))
          stored.files.push_back(*std::move(file));
    if (stored.files.size() == results.conditions.size()) return stored;
  }
  return std::nullopt;
}

std::vector<Drawing> drawOrganisms(const StudyResults& results, const std::filesystem::path& study,
                                   const GridMoments& moments, bool quiet) {
  if (const std::string why = whyTooMany(results, moments); !why.empty()) throw UsageError("--pictures: " + why);
  const std::size_t columns = columnsOf(results, moments);
  const bool spread = spreadsLastAxis(results, moments),
             ends = moments.count == 1 && moments.times.empty() && moments.cells.empty();
  std::optional<StoredPictures> stored;
  if (ends && moments.isUsual()) stored = storedPictures(results, study);
  if (stored && !haveOneScale(results, stored->seed, study)) stored.reset();
  const std::size_t seed = stored ? stored->seed : commonSeed(results);
  OrganismGrid grid;
  std::vector<double> times = moments.times;
  if (times.empty() && moments.cells.empty() && !ends) {
    Store store = Store::openForReading(study);
    double end = 0;
    for (const ResultCondition& condition : results.conditions)
      if (const std::size_t task = condition.tasks[seed]; results.isDone(task))
        end = std::max(end, store.find(results.tasks[task].runId).time);
    for (std::size_t i = 0; i < columns; ++i)
      times.push_back(end * static_cast<double>(i) / static_cast<double>(columns - 1));
  }
  if (spread) grid.columns = results.axes.back().labels;
  else if (ends) grid.columns = {"the end"};
  for (const std::size_t n : moments.cells) grid.columns.push_back(counted(n, "cell"));
  const Units units = unitsOf(results, study);
  if (!units.length.empty()) grid.lengthUnit = units.length, grid.perLength = units.perLength;
  for (const double t : times) grid.columns.push_back("time " + shownTime(units, t));
  std::map<std::size_t, std::vector<TakenTile>> known;  // by task: conditions may share runs
  std::vector<TakenTile> all;
  std::optional<Scenario> first;
  for (std::size_t k = 0; k < results.conditions.size(); ++k) {
    const ResultCondition& condition = results.conditions[k];
    const std::size_t task = condition.tasks.empty() ? noTask : condition.tasks[seed];
    if (!spread || condition.levels.back() == 0)
      grid.rows.push_back(linesOf(results, condition, results.axes.size() - (spread ? 1 : 0)));
    std::vector<TakenTile> tiles(spread ? 1 : columns, TakenTile{{{}, true, "no finished run"}});
    if (stored) {
      tiles = {TakenTile{{{}, false, "", readPng(readFile(stored->files[k]), stored->files[k].string())}}};
    } else if (results.isDone(task)) {
      if (!known.contains(task)) {
        const Scenario scenario = storedScenario(study.string(), results.tasks[task].runId);
        known[task] = tilesOf(results.tasks[task], scenario, study, times, moments, quiet);
        if (!first) first = scenario;
      }
      tiles = known[task];
    }
    all.insert(all.end(), tiles.begin(), tiles.end());
  }
  if (first) colourAlike(all, moments.colouring, *first, grid);
  for (TakenTile& taken : all) {
    taken.tile.picture.camera = moments.camera;
    grid.tiles.push_back(std::move(taken.tile));
  }
  grid.title = results.name;
  grid.caption = results.seeds.empty() ? "" : fmt::format("seed {}", results.seeds[seed]);
  if (stored) grid.caption += ", stored pictures";
  moments.figure.set(grid, organismGridText);
  return drawOrganismGrid(std::move(grid));
}

}  // namespace morula
