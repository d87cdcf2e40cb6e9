// morula lineage: the tree of cells as text, and as a picture.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "cli/cell_life.h"
#include "cli/verbs.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/picture_name.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "pictures/run_charts.h"
#include "store/store.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula::cli {
namespace {

struct LineageOptions {
  std::string file, run, picture, cell;
  std::optional<Colouring> colour;
  std::optional<PictureSize> size;
  bool labels = false;
  InputOptions input;
  OutputOptions output;
};

struct Tree {
  std::string scenario;
  double end = 0;      // [time] of the run
  RunResults results;  // only the lineage, the states' texts and the names
};

Tree stored(const LineageOptions& options) {
  auto store = Store::openForReading(options.file);
  const auto run = store.find(options.run);
  requireWholeRecord(store, run);
  return {run.record.scenario, run.time, options.colour ? store.results(run.id) : store.lineage(run.id)};
}

/// The tree as a picture, in the scenario's or the wanted colours.
void draw(const Tree& tree, const LineageOptions& options) {
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const auto describe = [&](StateId state) { return tree.results.stateTexts.at(state); };
  TreePicture picture = lineagePictureOf(tree.results.lineage, describe, tree.end, scenario);
  if (options.colour) colourTree(picture, tree.results, *options.colour, scenario);
  picture.labelsAll = options.labels;
  if (options.size) picture.width = options.size->width, picture.height = options.size->height;
  writePicture(drawLineage(picture), options.picture);
}

/// What the genes prescribe: without bodies a thousand cells take a moment. Where cells sense, or wait for a size, bodies
/// decide, too.
Tree prescribed(const LineageOptions& options) {
  auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const bool measured = options.colour && options.colour->by == Colouring::By::measure;
  if (!measured && scenario.scene.senses.empty() && !scenario.scene.cycle.divisionSize)
    scenario.scene.mechanics.reset();
  auto run =
      simulate(scenario, Execution{},
               {.quiet = options.output.quiet, .record = measured ? recordingOf(scenario, false) : RecordOptions{}});
  return {scenario.scene.name, run.end.time, std::move(run.results)};
}

std::string line(const LineageEntry& cell, const std::string& states, const std::string& called, const Units& units) {
  const auto path = cell.path.text();
  return std::string(2 * path.size(), ' ') +
         fmt::format(
             "{}{}{}  {} {}{}  {}\n", path.empty() ? "egg" : path, called.empty() ? "" : "  ", called, name(cell.fate),
             cell.fate == Fate::alive ? "since " : numberText(shownUnit(units, "time").factor * cell.born, 6) + "–",
             shownTime(units, cell.fate == Fate::alive ? cell.born : cell.ended, 6), states);
}

int tellLife(const Tree& tree, const LineageOptions& options) {
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const CellLife life = lifeOf(tree.results, tree.end, scenario.names, options.cell);
  printEither(options.output, {{"scenario", tree.scenario}, {"time", tree.end}, {"cell", lifeAsJson(life)}},
              lifeAsText(life, scenario.units));
  return fine;
}

int act(const LineageOptions& options) {
  auto tree = isDatabase(options.file) ? stored(options) : prescribed(options);
  if (!options.cell.empty()) return tellLife(tree, options);
  if (!options.picture.empty()) draw(tree, options);
  auto& cells = tree.results.lineage;
  // By path: a mother stands before her daughters, and a subtree is one block of lines.
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  const Units units =
      options.output.json ? Units{} : anyScenario(options.file, options.run, options.input.allowOutside).units;
  Json list = Json::array();
  for (const auto& cell : cells) {
    const auto& state = tree.results.stateTexts[cell.state];
    const auto named = tree.results.names.find(cell.path);
    const std::string called = named == tree.results.names.end() ? "" : named->second;
    if (!options.output.json) {
      print(line(cell, state, called, units));
      continue;
    }
    list.push_back(cellAsJson(cell, tree.results.names, state, tree.end));
  }
  if (!options.output.json) return fine;
  Json json{{"scenario", tree.scenario}, {"time", tree.end}, {"cells", list}};
  if (!options.picture.empty()) json["pictures"] = {options.picture};
  printJson(json);
  return fine;
}

}  // namespace

void addLineage(CLI::App& app, Action& action) {
  Verb verb(app, action, "lineage",
            "Print the tree of cells of a scenario or a stored run; a living cell's `ended` in --json is the "
            "run's end");
  auto& options = verb.does<LineageOptions>(act);
  verb.needs("file", options.file, "FILE", "A scenario or a database");
  addRunChoice(verb, options.run);
  verb.takes("--cell", options.cell, "CELL", "Only this cell's life; its name, or its path: AAB, egg");
  verb.takes("-o,--output", options.picture, "FILE", pictureName("lineage", true),
             "Also draw it: a .png, .svg or .pdf");
  verb.takes("--colour", options.colour, "WHAT", parseColouring,
             "Of branches, as render takes it: substance, clone, clone:N, generation, or a measure of cells, such "
             "as volume; default: substance");
  verb.takes("--labels", options.labels, "Name all leaves, however many there are");
  verb.takes("--size", options.size, "WxH", pictureSize(64, 16384),
             "Width and height in pixels; default: what suits the number of leaves");
  verb.oneOf({"--cell", "--output"});
  verb.onlyWith({"--colour", "--labels", "--size"}, {"--output"});
  add(verb, options.input);
  add(verb, options.output);
}

}  // namespace morula::cli
