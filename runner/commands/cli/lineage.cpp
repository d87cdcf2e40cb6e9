// morula lineage: the tree of cells as text, and as a picture.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

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
  std::string file, run, picture, cell, colour, size;
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
  return {run.record.scenario, run.time,
          options.colour.empty() ? store.lineage(run.id) : store.results(run.id)};
}

/// The measure of cells that branches are coloured by.
MeasureName colouring(const LineageOptions& options) {
  const bool scoped = options.colour.find('.') != options.colour.npos;
  return parseMeasure(scoped ? options.colour : "cell." + options.colour);
}

/// The tree as a picture, in the scenario's or a measure's colours.
void draw(const Tree& tree, const LineageOptions& options) {
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const auto describe = [&](StateId state) { return tree.results.stateTexts.at(state); };
  TreePicture picture = lineagePictureOf(tree.results.lineage, describe, tree.end, scenario);
  if (!options.colour.empty()) colourTree(picture, tree.results, colouring(options));
  picture.labelsAll = options.labels;
  if (!options.size.empty()) {
    const auto x = options.size.find('x');
    if (x == options.size.npos)
      throw UsageError("--size: '" + options.size + "' is no size; needs WIDTHxHEIGHT in pixels");
    picture.width = static_cast<int>(naturalOption("--size", options.size.substr(0, x), 64, 16384));
    picture.height = static_cast<int>(naturalOption("--size", options.size.substr(x + 1), 64, 16384));
  }
  writePicture(drawLineage(picture), options.picture);
}

/// What the genes prescribe: without bodies a thousand cells take a moment. Where cells sense, or wait for a size, bodies
/// decide, too.
Tree prescribed(const LineageOptions& options) {
  auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const bool measured = !options.colour.empty();
  if (!measured && scenario.scene.senses.empty() && !scenario.scene.cycle.divisionSize)
    scenario.scene.mechanics.reset();
  Progress progress(scenario.scene.name, options.output.quiet);
  RecordOptions record{.nameOf = scenario.names.function()};
  if (measured) record = recordingOf(scenario, false);
  auto run = simulate(makeScenarioWorld(scenario, {}), std::move(record), progress);
  return {scenario.scene.name, run.end.time, std::move(run.results)};
}

std::string line(const LineageEntry& cell, const std::string& states, const std::string& called) {
  const auto path = cell.path.text();
  return std::string(2 * path.size(), ' ') +
         fmt::format("{}{}{}  {} {}{}  {}\n", path.empty() ? "egg" : path, called.empty() ? "" : "  ", called,
                     name(cell.fate), cell.fate == Fate::alive ? "since " : fmt::format("{:.6g}–", cell.born),
                     fmt::format("{:.6g}", cell.fate == Fate::alive ? cell.born : cell.ended), states);
}

int tellLife(const Tree& tree, const LineageOptions& options) {
  const auto names = anyScenario(options.file, options.run, options.input.allowOutside).names;
  const CellLife life = lifeOf(tree.results, tree.end, names, options.cell);
  if (options.output.json)
    printJson({{"scenario", tree.scenario}, {"time", tree.end}, {"cell", lifeAsJson(life)}});
  else print(lifeAsText(life));
  return fine;
}

int act(const LineageOptions& options) {
  checkPictureName("lineage", options.picture, true);
  if (!options.cell.empty() && !options.picture.empty())
    throw UsageError(
        "--cell tells one cell's life, and --output draws the whole tree; leave out one of them");
  if (options.picture.empty() && (!options.colour.empty() || !options.size.empty() || options.labels))
    throw UsageError("--colour, --labels and --size are of the picture; needs --output, too");
  if (!options.colour.empty()) try {
      colouring(options);
    } catch (const InputError& error) { throw UsageError(std::string("--colour: ") + error.what()); }
  auto tree = isDatabase(options.file) ? stored(options) : prescribed(options);
  if (!options.cell.empty()) return tellLife(tree, options);
  if (!options.picture.empty()) draw(tree, options);
  auto& cells = tree.results.lineage;
  // By path: a mother stands before her daughters, and a subtree is one block of lines.
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  Json list = Json::array();
  for (const auto& cell : cells) {
    const auto& state = tree.results.stateTexts[cell.state];
    const auto named = tree.results.names.find(cell.path);
    const std::string called = named == tree.results.names.end() ? "" : named->second;
    if (!options.output.json) {
      print(line(cell, state, called));
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
  auto options = std::make_shared<LineageOptions>();
  Verb verb(app, action, "lineage",
            "Print the tree of cells of a scenario or a stored run; a living cell's `ended` in --json is the "
            "run's end");
  verb.needs("file", options->file, "FILE", "A scenario or a database");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--cell", options->cell, "CELL", "Only this cell's life; its name, or its path: AAB, egg");
  verb.takes("-o,--output", options->picture, "FILE", "Also draw it: a .png, .svg or .pdf");
  verb.takes("--colour", options->colour, "MEASURE",
             "Of branches: a measure of cells, such as volume; default: substances");
  verb.takes("--labels", options->labels, "Name all leaves, however many there are");
  verb.takes("--size", options->size, "WxH",
             "Width and height in pixels; default: what suits the number of leaves");
  add(verb, options->input);
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli
