// morula chart: what was measured of a run, as a chart.
#include <memory>

#include "base/error.h"
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

struct ChartOptions {
  std::string file, what, run, time, size, picture;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

struct Told {
  RunResults results;
  double end = 0;  // [time]
  int signal = 0;
};

Told resultsOf(const ChartOptions& options, const Scenario& scenario) {
  if (isDatabase(options.file)) {
    auto store = Store::openForReading(options.file);
    const auto run = store.find(options.run);
    return {store.results(run.id), run.time};
  }
  Progress progress(scenario.scene.name, options.output.quiet);
  auto run = simulate(makeScenarioWorld(scenario, execution(options.execution)), recordingOf(scenario, false),
                      progress);
  if (run.end.status == RunStatus::failed) throw InputError(run.end.failure);
  return {std::move(run.results), run.end.time, run.signal};
}

template <class Picture>
void setSize(Picture& picture, const std::string& size) {
  if (size.empty()) return;
  const auto x = size.find('x');
  if (x == size.npos) throw UsageError("--size: '" + size + "' is no size; needs WIDTHxHEIGHT in pixels");
  picture.width = static_cast<int>(naturalOption("--size", size.substr(0, x), 200, 8192));
  picture.height = static_cast<int>(naturalOption("--size", size.substr(x + 1), 200, 8192));
}

Drawing draw(const Told& told, const ChartOptions& options, const std::optional<MeasureName>& measure,
             const Scenario& scenario) {
  if (measure) {
    Chart chart = seriesOf(told.results, *measure, scenario);
    setSize(chart, options.size);
    return drawChart(chart);
  }
  if (options.what == "contacts") {
    const double time = options.time.empty() ? told.end : nonNegativeOption("--time", options.time);
    MatrixPicture matrix = contactsOf(told.results, time, scenario);
    setSize(matrix, options.size);
    return drawMatrix(matrix);
  }
  RosePicture roses = divisionsOf(told.results, scenario);
  setSize(roses, options.size);
  return drawRoses(roses);
}

int act(const ChartOptions& options) {
  std::optional<MeasureName> measure;
  if (options.what != "contacts" && options.what != "divisions") try {
      measure = parseMeasure(options.what);
    } catch (const InputError& error) {
      throw UsageError(std::string(error.what()) + "; or contacts, or divisions");
    }
  if (!options.time.empty() && options.what != "contacts")
    throw UsageError("--time says when contacts are shown; leave it out with " + options.what);
  checkPictureName("chart", options.picture, true);
  const auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  const Told told = resultsOf(options, scenario);
  if (told.signal) return signalled + told.signal;
  const std::string file =
      options.picture.empty() ? scenario.scene.name + "-" + options.what + ".svg" : options.picture;
  writePicture(draw(told, options, measure, scenario), file);
  if (options.output.json)
    printJson({{"scenario", scenario.scene.name}, {"time", told.end}, {"pictures", {file}}});
  else print(file + "\n");
  return fine;
}

}  // namespace

void addChart(CLI::App& app, Action& action) {
  auto options = std::make_shared<ChartOptions>();
  Verb verb(app, action, "chart",
            "Draw what was measured of a stored run, or of a scenario that is run for it");
  verb.needs("file", options->file, "FILE", "A database or a scenario");
  verb.needs("what", options->what, "WHAT",
             "A measure over time, such as cell.volume (scenarios/MEASURES.md); contacts: who touches whom; "
             "divisions: "
             "which way cells divided");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--time", options->time, "TIME", "Of contacts: when; default: at the end");
  verb.takes("--size", options->size, "WxH", "Width and height in pixels");
  verb.takes("-o,--output", options->picture, "FILE",
             "A .svg, .pdf or .png; default: the scenario's name and WHAT, as .svg");
  add(verb, options->input);
  add(verb, options->execution);
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli
