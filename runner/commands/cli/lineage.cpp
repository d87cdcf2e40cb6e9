// morula lineage: the tree of cells as text and as a picture.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "base/error.h"
#include "check/remarks.h"
#include "cli/verbs.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "simulation/genes_alone.h"
#include "store/records.h"
#include "store/store.h"
#include "system/console.h"
#include "system/json.h"
#include "system/usage_error.h"
#include "values/cell_names.h"
#include "values/measure_list.h"
#include "values/units.h"
#include "views/run_charts.h"

namespace morula::cli {
namespace {

struct Tree {
  std::string scenario;
  double end = 0;      // [time] of the run
  RunResults results;  // only lineage, texts of states, and names
};

/// A cell of a run, with its relatives. The run must outlive it.
struct CellLife {
  const LineageEntry* cell;
  const LineageEntry *mother = nullptr, *sister = nullptr;  // null: none
  std::vector<const LineageEntry*> daughters = {};          // empty: the cell did not divide
};

const LineageEntry* entryOf(const Tree& tree, const CellPath& path) {
  const auto at = std::ranges::find(tree.results.lineage, path, &LineageEntry::path);
  return at == tree.results.lineage.end() ? nullptr : &*at;
}

/// Returns the names of the tree's cells that have one.
NameOf nameIn(const Tree& tree) {
  return [&names = tree.results.names](const CellPath& path) -> std::optional<std::string> {
    const auto named = names.find(path);
    return named == names.end() ? std::nullopt : std::optional(named->second);
  };
}

CellPath pathOf(const CellNames& names, const std::string& text) {
  try {
    return cellCalled(names, text, "--cell");
  } catch (const InputError& error) {  // a mistake on the command line, not in a file
    throw UsageError(error.what());
  }
}

/// Throws that there never was such a cell, and names the last cell of its line of descent.
[[noreturn]] void refuseUnborn(const Tree& tree, const NameOf& nameOf, const CellPath& path) {
  CellPath last = path;
  while (!entryOf(tree, last) && !last.isEgg()) last = last.mother();
  const LineageEntry* ancestor = entryOf(tree, last);
  MORULA_CHECK(ancestor && last != path, "a tree of cells holds the egg");
  throw UsageError("--cell: " + cellWords(nameOf, path) + " was never born: " + cellWords(nameOf, last) +
                   (ancestor->fate == Fate::died ? fmt::format(" died at {:.6g}", ancestor->ended)
                                                 : fmt::format(" lives at the run's end, {:.6g}", tree.end)) +
                   "; needs a cell that 'morula lineage' lists without --cell");
}

Json relative(const LineageEntry* cell, const NameOf& nameOf) {
  if (!cell) return {};
  return {{"path", cell->path.text()}, {"name", orNull(nameOf(cell->path))}};
}

/// Returns the cell that `text` means by name or path [cellCalled]. Throws UsageError that begins with "--cell" if
/// there is none, or the run never had it.
CellLife lifeOf(const Tree& tree, const CellNames& names, const std::string& text) {
  const CellPath path = pathOf(names, text);
  CellLife life{entryOf(tree, path)};
  if (!life.cell) refuseUnborn(tree, names.function(), path);
  if (!path.isEgg()) {
    life.mother = entryOf(tree, path.mother());
    life.sister = entryOf(tree, path.mother().daughter(!path.letter(path.depth() - 1)));
  }
  if (life.cell->fate == Fate::divided)  // a path of the greatest depth has no daughters, and never divides
    for (const bool b : {false, true})
      if (const LineageEntry* daughter = entryOf(tree, path.daughter(b))) life.daughters.push_back(daughter);
  return life;
}

/// Writes a line for each of path, name, born, ended, fate, state, mother, daughters and sister, if the cell has it.
std::string lifeAsText(const CellLife& life, const Tree& tree, const Units& units) {
  const NameOf nameOf = nameIn(tree);
  const LineageEntry& cell = *life.cell;
  std::string text;
  const auto line = [&](const char* what, const std::string& value) {
    text += fmt::format("{:<10} {}\n", what, value);
  };
  const auto words = [&](const LineageEntry* relative) { return cellWords(nameOf, relative->path); };
  line("path", cell.path.isEgg() ? "egg" : cell.path.text());
  if (const auto name = nameOf(cell.path)) line("name", *name);
  line("born", shownTime(units, cell.born, 6));
  if (cell.fate == Fate::alive) line("ended", "not before the run's end, " + shownTime(units, tree.end, 6));
  else line("ended", shownTime(units, cell.ended, 6));
  line("fate", name(cell.fate));
  if (const auto& state = tree.results.stateTexts.at(cell.state); !state.empty()) line("state", state);
  if (life.mother) line("mother", words(life.mother));
  if (life.daughters.size() == 2) line("daughters", words(life.daughters[0]) + ", " + words(life.daughters[1]));
  if (life.sister) line("sister", words(life.sister));
  return text;
}

/// Writes a cell of the whole tree: "path", "name", "parent", "born", "ended", "fate", "state". The `ended` of a living
/// cell is the run's end.
Json cellAsJson(const LineageEntry& cell, const Tree& tree) {
  return {{"path", cell.path.text()},
          {"name", orNull(nameIn(tree)(cell.path))},
          {"parent", cell.path.isEgg() ? Json() : Json(cell.path.mother().text())},
          {"born", cell.born},
          {"ended", cell.fate == Fate::alive ? tree.end : cell.ended},
          {"fate", name(cell.fate)},
          {"state", tree.results.stateTexts.at(cell.state)}};
}

/// Writes a cell as JSON: "path", "name", "parent", "born", "ended", "fate" and "state" as a cell of the whole tree;
/// "mother" and "sister" as {"path", "name"}, or null; "daughters" as a list of {"path", "name"}.
Json lifeAsJson(const CellLife& life, const Tree& tree) {
  const NameOf nameOf = nameIn(tree);
  Json json = cellAsJson(*life.cell, tree);
  json["mother"] = relative(life.mother, nameOf);
  json["sister"] = relative(life.sister, nameOf);
  json["daughters"] = Json::array();
  for (const LineageEntry* daughter : life.daughters) json["daughters"].push_back(relative(daughter, nameOf));
  return json;
}

struct LineageOptions {
  std::string file, run, picture, cell;
  std::optional<Colouring> colour;
  FigureOptions figure;
  bool labels = false;
  InputOptions input;
  OutputOptions output;
};

Tree stored(const LineageOptions& options) {
  auto store = Store::openForReading(options.file);
  const auto run = store.find(options.run);
  requireToShow(store, run);
  return {run.record.scenario, run.time, options.colour ? store.results(run.id) : store.lineage(run.id)};
}

/// Draws the tree in the scenario's colours or the colours asked for.
void draw(const Tree& tree, const LineageOptions& options) {
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const auto describe = [&](StateId state) { return tree.results.stateTexts.at(state); };
  TreePicture picture = lineagePictureOf(tree.results.lineage, describe, tree.end, scenario, tree.results.experiments);
  if (options.colour) colourTree(picture, tree.results, *options.colour, scenario);
  picture.labelsAll = options.labels;
  options.figure.both().set(picture, figureText);
  writePicture(drawLineage(picture), options.picture);
}

/// Computes the lineage by genes alone: without bodies a thousand cells take a moment. Bodies are computed if cells
/// sense or wait for a size.
Tree prescribed(const LineageOptions& options) {
  auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const bool measured = options.colour && options.colour->by == Colouring::By::measure;
  if (!measured && scenario.scene.senses.empty() && !scenario.scene.cycle.divisionSize &&
      std::ranges::none_of(scenario.scene.experiments, [](const Experiment& e) { return needsBodies(e); }) &&
      std::ranges::none_of(scenario.scene.stop.when, [](const StopWhen& when) { return needsBodies(when); }))
    scenario.scene.mechanics.reset();
  auto run =
      simulate(scenario, Execution{},
               {.quiet = options.output.quiet, .record = measured ? recordingOf(scenario, false) : RecordOptions{}});
  return {scenario.scene.name, run.end.time, std::move(run.results)};
}

std::string line(const LineageEntry& cell, const Tree& tree, const Units& units) {
  const std::string path = cell.path.text(), called = nameIn(tree)(cell.path).value_or("");
  return std::string(2 * path.size(), ' ') +
         fmt::format(
             "{}{}{}  {} {}{}  {}\n", path.empty() ? "egg" : path, called.empty() ? "" : "  ", called, name(cell.fate),
             cell.fate == Fate::alive ? "since " : numberText(shownUnit(units, "time").factor * cell.born, 6) + "–",
             shownTime(units, cell.fate == Fate::alive ? cell.born : cell.ended, 6),
             tree.results.stateTexts.at(cell.state));
}

int tellLife(const Tree& tree, const LineageOptions& options) {
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const CellLife life = lifeOf(tree, scenario.names, options.cell);
  printEither(options.output,
              {{"scenario", tree.scenario},
               {"time", tree.end},
               {"units", knownUnits(scenario.units)},
               {"cell", lifeAsJson(life, tree)}},
              lifeAsText(life, tree, scenario.units));
  return fine;
}

int act(const LineageOptions& options) {
  auto tree = isDatabase(options.file) ? stored(options) : prescribed(options);
  if (!options.cell.empty()) return tellLife(tree, options);
  if (!options.picture.empty()) draw(tree, options);
  if (!options.picture.empty() && options.output.quiet && !options.output.json) return fine;
  auto& cells = tree.results.lineage;
  // Paths in order put a mother before her daughters, and a subtree into one block of lines.
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  const Scenario scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  std::vector<std::string> done;
  for (const std::string& line : experimentLines(scenario, tree.results.experiments))
    done.push_back(withNames(line, scenario.names.function()));
  Json list = Json::array();
  for (const auto& cell : cells)
    if (options.output.json) list.push_back(cellAsJson(cell, tree));
    else print(line(cell, tree, scenario.units));
  if (!options.output.json) {
    for (const std::string& deed : done) print("experiment: " + deed + "\n");
    return fine;
  }
  Json json{{"scenario", tree.scenario}, {"time", tree.end}, {"units", knownUnits(scenario.units)}, {"cells", list}};
  if (!done.empty()) json["experiments"] = done;
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
  verb.takes("--cell", options.cell, "CELL", "Print only the life of this cell, given by its name or path: AAB, egg");
  verb.takes("-o,--output", options.picture, "FILE", pictureName("lineage", true),
             "Also draw the tree into this file: .png, .svg or .pdf; with --quiet the tree is not printed");
  verb.takes(
      "--colour", options.colour, "WHAT", parseColouring,
      "Colour of branches, as render takes it: substance, clone, clone:N, generation, or a measure of cells, such "
      "as volume; default: substance");
  verb.takes("--labels", options.labels, "Name all leaves, however many there are");
  addFigure(verb, options.figure, 64, 16384);
  verb.oneOf({"--cell", "--output"});
  verb.onlyWith({"--colour", "--labels", "--size"}, {"--output"});
  add(verb, options.input);
  add(verb, options.output);
}

}  // namespace morula::cli
