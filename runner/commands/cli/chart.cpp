// morula chart: measured values of a run, as a chart.

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "cli/verbs.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "store/store.h"
#include "system/console.h"
#include "system/usage_error.h"
#include "values/cell_words.h"
#include "views/run_charts.h"

namespace morula::cli {
namespace {

struct ChartOptions {
  std::string file, what, run, picture;
  std::optional<double> time;
  FigureOptions figure;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

struct RunToDraw {
  RunResults results;
  double end = 0;  // [time]
};

RunToDraw resultsOf(const ChartOptions& options, const Scenario& scenario) {
  if (isDatabase(options.file)) {
    auto store = Store::openForReading(options.file);
    const auto run = store.find(options.run);  // anyScenario has checked the digests of its rows
    return {store.results(run.id), run.time};
  }
  auto run = simulate(scenario, execution(options.execution),
                      {.quiet = options.output.quiet, .record = recordingOf(scenario, false)});
  if (run.end.status == RunStatus::failed) throw InputError(run.end.failure);
  return {std::move(run.results), run.end.time};
}

template <class Picture>
Picture ofSize(Picture picture, const FigureOptions& figure) {
  figure.both().set(picture, figureText);
  return picture;
}

Drawing draw(const RunToDraw& run, const ChartOptions& options, const std::optional<AskedMeasure>& measure,
             const Scenario& scenario) {
  if (measure) return drawChart(ofSize(seriesOf(run.results, *measure, scenario), options.figure));
  if (options.what == "contacts")
    return drawMatrix(ofSize(contactsOf(run.results, options.time.value_or(run.end), scenario), options.figure));
  return drawRoses(ofSize(divisionsOf(run.results, scenario), options.figure));
}

int act(const ChartOptions& options) {
  if (options.time && options.what != "contacts")
    throw UsageError("--time is the time of contacts; leave it out with " + options.what);
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  std::optional<AskedMeasure> measure;
  if (options.what != "contacts" && options.what != "divisions") try {
      measure = resolved(readMeasure(options.what, IfSeveral::first), scenario.names, scenario.scene.dna);
    } catch (const InputError& error) {
      throw UsageError(std::string("WHAT needs a measure, contacts or divisions: ") + error.what());
    }
  const RunToDraw run = resultsOf(options, scenario);
  if (options.time && *options.time > run.end)
    throw UsageError(
        fmt::format("--time: {} is after the end of the run; needs at most {:.6g}", exactText(*options.time), run.end));
  std::string file = scenario.scene.name + "-" + options.what + ".svg";
  std::ranges::replace(file, ' ', '-'), std::ranges::replace(file, '*', '+'), std::ranges::replace(file, '/', '.');
  if (!options.picture.empty()) file = options.picture;
  writePicture(draw(run, options, measure, scenario), file);
  printEither(options.output, {{"scenario", scenario.scene.name}, {"time", run.end}, {"pictures", {file}}},
              file + "\n");
  return fine;
}

}  // namespace

void addChart(CLI::App& app, Action& action) {
  Verb verb(app, action, "chart", "Draw measures of a stored run, or of a scenario, which is run first");
  auto& options = verb.does<ChartOptions>(act);
  verb.needs("file", options.file, "FILE", "A database or a scenario");
  verb.needs(
      "what", options.what, "WHAT",
      "A measure over time, such as cell.volume (scenarios/MEASURES.md), also of some cells, as 'shell_share "
      "of AAA*', or 'distance cell ABa cell P2'; contacts: areas between cells; divisions: directions of division axes");
  addRunChoice(verb, options.run);
  verb.takes("--time", options.time, "TIME", number(scenario::notNegative),
             "Time of the contacts that are drawn; default: the end");
  addFigure(verb, options.figure, 200, 8192);
  verb.takes("-o,--output", options.picture, "FILE", pictureName("chart", true),
             "File to write: .svg, .pdf or .png; default: the scenario's name and WHAT, as .svg");
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli
