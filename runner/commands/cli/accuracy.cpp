// morula accuracy: speed against error, over time steps, integrators, meshes, precisions, contact laws and cell models.
#include "accuracy/accuracy.h"

#include <algorithm>

#include "accuracy/subject.h"
#include "accuracy/target.h"
#include "base/error.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "loop/simulate.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/program.h"
#include "options/verb.h"
#include "physics/integrator.h"
#include "pictures/pictures.h"
#include "simulation/simulation.h"
#include "system/child_process.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct AccuracyCommand {
  std::string scenario;
  AccuracyOptions options{.budget = 120};
  std::optional<double> target;
  std::string out = "results", picture;
  bool only = false, quick = false;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
};

/// Completes the options with settings to try.
AccuracyOptions optionsOf(const AccuracyCommand& command, const Scenario& scenario, World start) {
  AccuracyOptions options = command.options;
  const bool only = command.only || command.quick;
  if (command.quick) options.halvings = options.rounds = 1;
  if (command.quick && !options.until) options.until = timeReached(std::move(start), 32, INFINITY);
  if (options.integrators.empty())
    for (const auto integrator : valuesOf<Integrator>())
      if (!kindOf(integrator).settles) options.integrators.push_back(integrator);  // others have no time step
  // The next coarser mesh is tried, unless others are asked for.
  const auto own = scenario.mesh.icosphere;
  if (options.levels.empty() && !only && !scenario.mesh.file &&
      !(scenario.scene.mechanics && scenario.scene.mechanics->physics.coarsen) && own && *own > 1)
    options.levels.push_back(*own - 1);
  options.otherPrecision = options.otherLaw = options.cheaperModels = !only;
  options.program = ownProgram();
  options.execution = execution(command.execution);
  options.tell = [quiet = command.output.quiet](const std::string& text) { tell("accuracy: " + text, quiet); };
  return options;
}

/// Reports a scene without a time step, whose error is its distance from rest.
int tellSettlings(const AccuracyCommand& command, const Scenario& scenario) {
  const Table settlings = measureSettlings(scenario, execution(command.execution));
  if (command.output.json)
    printJson({{"file", scenario.file},
               {"settlings", jsonOf(settlings)},
               {"made_by", originOf(scenario, execution(command.execution), commandLine())}});
  else
    print(textOf(settlings) + "\nleft: " +
          (scenario.scene.mechanics->physics.integrator == Integrator::quasiStatic
               ? "energy in the motion"
               : "until the residual is a hundredth of physics.settle.tolerance") +
          "; no time step, no error of it\n");
  return fine;
}

int act(const AccuracyCommand& command) {
  const std::string& file = command.scenario;
  const ReadScenario read = variantsOf(file, overrides(command.scene), command.input.allowOutside);
  const Scenario scenario = read({});
  if (!command.target && scenario.scene.mechanics && kindOf(scenario.scene.mechanics->physics.integrator).settles)
    return tellSettlings(command, scenario);
  refuseWithoutError(scenario);
  World start = makeScenarioWorld(scenario, execution(command.execution));  // mistakes are reported with their places
  const auto options = optionsOf(command, scenario, std::move(start));
  if (command.options.until)
    requireWithinScene(makeScenarioWorld(scenario, execution(command.execution)), *options.until);
  const auto folder = std::filesystem::path(command.out) / "accuracy";
  makeFolder(folder);
  const auto report = measureAccuracy(read, options);

  auto picture = command.picture;
  if (picture.empty()) picture = (folder / (report.scenario + ".png")).string();
  writePicture(drawAccuracy(report), picture);
  Json json = command.output.json ? toJson(report, picture) : Json();
  std::string text = command.output.json ? "" : textOf(describe(report));
  bool held = true;
  if (command.target) {
    const auto seed = command.scene.seed ? std::to_string(*command.scene.seed) : "";
    const TargetQuestion question{*command.target, file, command.scene.set, seed, options.budget, options.program,
                                  folder.string(), read, options.tell};
    const TargetAnswer answer = findTarget(report, question);
    held = answer.best.has_value();
    if (command.output.json) json["target"] = toJson(answer, question, report);
    else text += "\n" + describe(answer, question, report);
  }
  if (command.output.json) {
    json["file"] = file, json["made_by"] = originOf(scenario, options.execution, commandLine());
    printJson(json);
  } else print(text + "\npicture  " + picture + "\n");
  return held ? fine : differs;
}

}  // namespace

void addAccuracy(CLI::App& app, Action& action) {
  Verb verb(app, action, "accuracy",
            "Compare integrators, time steps, meshes, precisions and cell models on a scene, by speed and error");
  auto& command = verb.does<AccuracyCommand>(act);
  verb.needs("scenario", command.scenario, "FILE", "A scenario file");
  verb.takes("--until", command.options.until, "T", number(scenario::positive),
             "Compare up to this time; default: before chaos sets in");
  verb.takes("--target", command.target, "ERROR", number(scenario::positive),
             "Name the cheapest settings whose error on the scenario's mesh is no larger, as 1e-2, as a "
             "command that has been run to its end, and what the mesh adds; exit 1 without any");
  verb.takes("--integrator", command.options.integrators, "NAME,...", parseChoice<Integrator>,
             "Only these beside the scenario's own, as rk4,explicit-euler");
  verb.takes("--level", command.options.levels, "N,...", natural(0, 4),
             "Other icospheres, as 1,3; default: the next coarser one");
  verb.takes("--bullet", command.options.bullet,
             "Also compare with Bullet's soft bodies, if Bullet can compute the scene");
  verb.takes("--budget", command.options.budget, "SECONDS", number(scenario::positive),
             "Max CPU time of the runs on finer meshes, and of those of --target to their ends");
  verb.takes("--only", command.only, "No other meshes, precision, contact law or cell model than the scenario's");
  verb.takes("--quick", command.quick, "A first look: 32 steps of the scenario, few others beside it, once each");
  verb.takes("--halvings", command.options.halvings, "N", natural(1, 10),
             "How often the longest time step is halved; it is twice the scenario's smallest");
  verb.takes("--rounds", command.options.rounds, "N", natural(1, 100), "Runs of each setting, to measure the CPU time");
  verb.takes("--out", command.out, "FOLDER", "Folder for results");
  verb.takes("-o,--output", command.picture, "FILE", pictureName("accuracy", true),
             "The chart, a .png, .svg or .pdf; default: the scenario's name in the folder");
  add(verb, command.input);
  add(verb, command.scene);
  add(verb, command.execution);
  add(verb, command.output);
  verb.excludes("--quick", {"--target"}, "--quick is a first look");
}

}  // namespace morula::cli
