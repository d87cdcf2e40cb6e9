// morula render: one picture of a scenario, or of a stored run, at any time of its life.
#include <fmt/format.h>

#include <memory>

#include "base/error.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/picture_name.h"
#include "cli/verb.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "pictures/pictures.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct RenderOptions {
  std::string file, run, time, style = "solid", size = "900", output;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions messages;
};

void draw(const World& world, const Scenario& scenario, const RenderOptions& options,
          const std::string& file) {
  const int size = static_cast<int>(naturalOption("--size", options.size, 64, 8192));
  if (options.style == "lineage") {
    auto tree = lineagePictureOf(world, scenario);
    if (options.size != "900") tree.width = size;
    return writePicture(drawLineage(tree), file);
  }
  auto picture = pictureOf(world, scenario);
  picture.width = picture.height = size;
  if (options.style == "both") return writePicture(drawSolidAndWireframe(picture), file);
  writePicture(drawOrganism(picture, options.style == "wireframe" ? Style::wireframe : Style::solid), file);
}

[[noreturn]] void failAfterEnd(const std::string& time, double end) {
  throw UsageError(
      fmt::format("--time: {} is after the end of the run, {:.6g}; needs at most that", time, end));
}

int act(const RenderOptions& options) {
  const std::vector<std::string> styles{"solid", "wireframe", "both", "lineage"};
  if (std::find(styles.begin(), styles.end(), options.style) == styles.end())
    throw UsageError("--style: '" + options.style +
                     "' is not known; needs solid, wireframe, both or lineage");
  checkPictureName("render", options.output, options.style == "lineage");
  // Positions are not stored: the same bits come out of running again.
  auto scenario = anyScenario(options.file, options.run, options.input.allowOutside);
  if (!scenario.scene.mechanics && options.style != "lineage")
    throw UsageError("--style: " + scenario.scene.name + " has no bodies; needs lineage");
  std::optional<double> time;
  if (!options.time.empty()) {
    time = nonNegativeOption("--time", options.time);
    if (const auto end = plannedEnd(scenario.scene); end && *time > *end) failAfterEnd(options.time, *end);
  }
  Progress progress(scenario.scene.name, options.messages.quiet);
  World world = makeScenarioWorld(scenario, execution(options.execution));
  if (time)
    world.model.stop.time =
        time;  // of the world, not of the scenario: it runs as it always does, only not so far
  const auto run = simulate(std::move(world), {.nameOf = scenario.names.function()}, progress);
  if (run.signal) return signalled + run.signal;
  if (run.end.status == RunStatus::failed) {
    tellError(run.end.failure);
    return numerical;
  }
  // A run may end before its planned end: by its number of cells, or when all have died.
  if (time && run.world.bodies && run.end.time < *time * (1 - 1e-9)) failAfterEnd(options.time, run.end.time);
  const auto file = options.output.empty() ? scenario.scene.name + ".png" : options.output;
  draw(run.world, scenario, options, file);
  if (options.messages.json)
    printJson({{"scenario", scenario.scene.name}, {"time", run.end.time}, {"pictures", {file}}});
  else print(file + "\n");
  return fine;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  Verb verb(app, action, "render", "Draw a scenario or a stored run, at its end or another time");
  verb.needs("file", options->file, "FILE", "A scenario or a database");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--time", options->time, "TIME", "When; default: at the end");
  verb.takes("--style", options->style, "NAME", "solid, wireframe, both or lineage");
  verb.takes("--size", options->size, "N", "Width in pixels");
  verb.takes("-o,--output", options->output, "FILE",
             "The PNG, and of a lineage also .svg or .pdf; default: the scenario's name");
  add(verb, options->input);
  add(verb, options->execution);
  add(verb, options->messages);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli
