// morula parts: the parts that a scenario uses, why, and what each will cost.
#include "parts/parts.h"

#include "base/error.h"
#include "check/check_run.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "loop/simulate.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "parts/prediction.h"
#include "pictures/pictures.h"
#include "system/clock.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct PartsOptions {
  std::string scenario;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
  std::optional<double> rehearsal;
  bool noPictures = false;
};

/// Estimates the CPU time of a picture [s] by small pictures of the egg: most of it is proportional to pixels.
double secondsPerPicture(const Scenario& scenario, const World& world) {
  auto picture = pictureOf(world, scenario);
  const auto secondsOf = [&](int width) {
    const double before = seconds(ClockKind::process);
    auto small = picture;
    small.width = small.height = width;
    drawOrganism(small);
    return seconds(ClockKind::process) - before;
  };
  // Widths of width/6 and width/3 are 1 and 4 parts of 36.
  const double few = secondsOf(picture.width / 6), more = secondsOf(picture.width / 3);
  return few + std::max(more - few, 0.0) / 3 * 35;
}

Json toJson(const Prediction& f, const Scenario& scenario, const Execution& how) {
  Json parts = jsonOf(costTable(f));
  for (const Json& absent : jsonOf(absentTable(f))) parts.push_back(absent);
  return {{"scenario", scenario.scene.name},
          {"isa", name(how.isa)},
          {"cells", f.cells},
          {"vertices", f.vertices},
          {"steps", f.steps},
          {"vertex_steps", f.vertexSteps},
          {"pair_evaluations", f.pairs},
          {"searches", f.searches},
          {"seconds", f.seconds()},
          {"bytes", f.bytes()},
          {"rehearsed_time", f.triedTime},
          {"rehearsed", f.triedWhole},
          {"parts", parts},
          {"bounds_time_step", f.binding ? Json{{"part", f.binding->part}, {"factor", f.binding->factor}} : Json()},
          {"remarks", f.remarks}};
}

int act(const PartsOptions& options) {
  const auto scenario = loadScenario(options.scenario, overrides(options.scene), options.input.allowOutside);
  PredictionOptions how;
  how.execution = execution(options.execution);
  how.ask.search = how.execution.search.method;
  if (options.scene.empty() && fileExists(goldenFile(scenario))) how.ask.golden = goldenFile(scenario).string();
  const World world = makeScenarioWorld(scenario, how.execution);  // mistakes are reported with their places
  how.ask.pictures = !options.noPictures;
  if (options.rehearsal) how.trial = *options.rehearsal;
  if (world.bodies && how.ask.pictures) how.secondsPerPicture = secondsPerPicture(scenario, world);
  const Prediction prediction = predictCost(scenario, how);
  printEither(options.output, toJson(prediction, scenario, how.execution),
              textOf(describe(prediction, scenario.scene.name + ", " + name(how.execution.isa))));
  return fine;
}

}  // namespace

void addParts(CLI::App& app, Action& action) {
  Verb verb(app, action, "parts", "List the parts that a scenario engages, with the reason and the cost of each");
  auto& options = verb.does<PartsOptions>(act);
  verb.needs("scenario", options.scenario, "FILE", "A scenario file");
  add(verb, options.input);
  add(verb, options.scene);
  add(verb, options.execution);
  verb.takes("--rehearsal", options.rehearsal, "N", number(scenario::positive),
             "Length of the rehearsal in steps times vertices, by default 8e6; shorter ones predict less exactly");
  verb.takes("--no-pictures", options.noPictures, "Predict a run with --no-pictures");
  add(verb, options.output);
}

}  // namespace morula::cli
