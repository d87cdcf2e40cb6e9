// morula accuracy: speed against error, over time steps, integrators, meshes, precisions, contact laws and cell models.
#include "accuracy/accuracy.h"

#include <fmt/format.h>

#include <algorithm>

#include "accuracy/into_golden.h"
#include "accuracy/target.h"
#include "base/error.h"
#include "base/number_text.h"
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

struct AccuracyWords {
  std::vector<std::string> scenarios;
  AccuracyOptions options{.budget = 120};
  std::optional<double> target;
  std::string out = "results", picture;
  bool only = false, intoGolden = false, quick = false, stated = false;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
};

/// Returns the time [time] after so many steps, at the scene's end, or at `latest`, whichever comes first.
double timeReached(World world, std::uint64_t steps, double latest) {
  for (; steps > 0 && world.clock.time < latest && !finished(world); --steps) step(world);
  return world.clock.time;
}

/// Returns the scene's end [time] if it comes before `time`; absent if the run fails on the way.
std::optional<double> endBefore(World world, double time) {
  try {
    const double end = plannedEnd(world.model).value_or(0);
    const double reached = end > 0 ? end : timeReached(std::move(world), UINT64_MAX, time);
    return reached < time * (1 - 1e-9) ? std::optional(reached) : std::nullopt;
  } catch (const NumericalError&) { return {}; }
}

/// Completes the options with settings to try.
AccuracyOptions optionsOf(const AccuracyWords& words, const Scenario& scenario, World start) {
  AccuracyOptions options = words.options;
  const bool only = words.only || words.quick;
  if (words.quick) options.halvings = options.rounds = 1;
  if (words.quick && !options.until) options.until = timeReached(std::move(start), 32, INFINITY);
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
  options.brief = words.intoGolden;
  options.execution = execution(words.execution);
  options.tell = [quiet = words.output.quiet](const std::string& text) { tell("accuracy: " + text, quiet); };
  return options;
}

/// Makes a reader of the scenario, with the changes asked for and further ones.
ReadScenario readerOf(const AccuracyWords& words, const std::string& file) {
  return [&words, file](const std::vector<std::string>& changes) {
    auto all = overrides(words.scene);
    for (const auto& change : changes) {
      const auto path = change.substr(0, change.find('='));
      std::erase_if(all, [&](const Override& o) { return o.path == path; });
      all.push_back(parseOverride(change));
    }
    if (!changes.empty()) {  // for variants; a check's reference may not fit them
      all.push_back(parseOverride("check={}"));
      all.push_back(parseOverride("record.measures=null"));
    }
    return loadScenario(file, all, words.input.allowOutside);
  };
}

/// Returns the origin of the numbers: seconds of CPU time belong to one machine.
Json provenance(const Scenario& scenario, const Execution& how) {
  const RunRecord record = recordOf(scenario, how, commandLine());
  Json json = Json::object();
  eachFieldOf({.record = record}, [&](const RunField& field, const std::string& value) {
    if (field.part != RunPart::result && !value.empty()) json[headingOf(field)] = value;
  });
  return json;
}

/// Reports a scene without a time step, whose error is its distance from rest.
int tellSettlings(const AccuracyWords& words, const Scenario& scenario) {
  const Table settlings = measureSettlings(scenario, execution(words.execution));
  if (words.output.json)
    printJson({{"file", scenario.file},
               {"settlings", jsonOf(settlings)},
               {"made_by", provenance(scenario, execution(words.execution))}});
  else
    print(textOf(settlings) +
          "\nleft: until the residual is a hundredth of physics.settle.tolerance; no time step, no error of it\n");
  return fine;
}

/// Measures one scenario and prints its report to stdout.
int actOn(const AccuracyWords& words, const std::string& file) {
  const ReadScenario read = readerOf(words, file);
  const Scenario scenario = read({});
  if (!words.intoGolden && !words.target && scenario.scene.mechanics &&
      kindOf(scenario.scene.mechanics->physics.integrator).settles)
    return tellSettlings(words, scenario);
  if (words.intoGolden) refuseIntoGolden(scenario);
  else refuseWithoutError(scenario);
  World start = makeScenarioWorld(scenario, execution(words.execution));  // mistakes are reported with their places
  const auto options = optionsOf(words, scenario, std::move(start));
  if (words.options.until)
    if (const auto end = endBefore(makeScenarioWorld(scenario, execution(words.execution)), *options.until))
      throw UsageError(fmt::format("--until: {} is after the scene's end; needs at most {}", exactText(*options.until),
                                   numberText(*end)));
  const auto folder = std::filesystem::path(words.out) / "accuracy";
  makeFolder(folder);
  const auto report = words.intoGolden ? stateInGolden(read, options) : measureAccuracy(read, options);

  auto picture = words.picture;
  if (picture.empty() && !options.brief) picture = (folder / (report.scenario + ".png")).string();
  if (!picture.empty()) writePicture(drawAccuracy(report), picture);
  Json json = words.output.json ? toJson(report, picture) : Json();
  std::string text = words.output.json ? "" : textOf(describe(report));
  bool held = true;
  if (words.target) {
    const auto seed = words.scene.seed ? std::to_string(*words.scene.seed) : "";
    const TargetQuestion question{*words.target,   file, words.scene.set, seed, options.budget, options.program,
                                  folder.string(), read, options.tell};
    const TargetAnswer answer = findTarget(report, question);
    held = answer.best.has_value();
    if (words.output.json) json["target"] = toJson(answer, question, report);
    else text += "\n" + describe(answer, question, report);
  }
  if (words.output.json) {
    json["file"] = file, json["made_by"] = provenance(scenario, options.execution);
    printJson(json);
  } else print(text + (picture.empty() ? "" : "\npicture  " + picture + "\n"));
  return held ? fine : differs;
}

/// Prints the errors that golden files of scenes with bodies state.
int tellStated(const AccuracyWords& words) {
  std::vector<Golden> goldens;
  for (const std::string& file : words.scenarios) goldens.push_back(readGoldenFile(file));
  std::erase_if(goldens, [](const Golden& g) { return !hasBodies(g); });
  print(statedErrorsAsMarkdown(goldens));
  return fine;
}

/// Measures several scenarios, into their goldens. A scenario without an error to state is reported and skipped.
int actOnAll(const AccuracyWords& words) {
  int code = fine;
  for (const std::string& file : words.scenarios) {
    try {
      const Scenario scenario = loadScenario(file, {}, words.input.allowOutside);
      if (!scenario.scene.mechanics || !scenario.check.fails.empty()) {
        tell("accuracy: " + file + ": left out: " + (scenario.scene.mechanics ? "it must fail" : "it has no bodies"),
             words.output.quiet);
        continue;
      }
      actOn(words, file);
    } catch (const InputError& error) {
      tellInputError(error.what());
      code = input;
    }
  }
  return code;
}

int act(const AccuracyWords& words) {
  if (words.stated) return tellStated(words);
  if (words.scenarios.size() == 1) return actOn(words, words.scenarios.front());
  if (!words.intoGolden || words.output.json)
    throw UsageError("accuracy takes several scenarios only with --into-golden and without --json");
  return actOnAll(words);
}

}  // namespace

void addAccuracy(CLI::App& app, Action& action) {
  Verb verb(app, action, "accuracy",
            "Compare integrators, time steps, meshes, precisions and cell models on a scene, by speed and error");
  auto& words = verb.does<AccuracyWords>(act);
  verb.needs("scenario", words.scenarios, "FILE",
             "A scenario file; several with --into-golden; golden files with --stated");
  verb.takes("--until", words.options.until, "T", number(scenario::positive),
             "Compare up to this time; default: before chaos sets in");
  verb.takes("--target", words.target, "ERROR", number(scenario::positive),
             "Name the cheapest settings whose error on the scenario's mesh is no larger, as 1e-2, as a "
             "command that has been run to its end, and what the mesh adds; exit 1 without any");
  verb.takes("--integrator", words.options.integrators, "NAME,...", parseChoice<Integrator>,
             "Only these beside the scenario's own, as rk4,explicit-euler");
  verb.takes("--level", words.options.levels, "N,...", natural(0, 4),
             "Other icospheres, as 1,3; default: the next coarser one");
  verb.takes("--bullet", words.options.bullet,
             "Also compare with Bullet's soft bodies, if Bullet can compute the scene");
  verb.takes("--into-golden", words.intoGolden,
             "Write the error of the scenario as it is into its golden file; nothing else is tried");
  verb.takes("--stated", words.stated,
             "Print what these golden files state, as golden/ERRORS.md does, and compute nothing");
  verb.takes("--budget", words.options.budget, "SECONDS", number(scenario::positive),
             "Max CPU time of the runs on finer meshes, and of those of --target to their ends");
  verb.takes("--only", words.only, "No other meshes, precision, contact law or cell model than the scenario's");
  verb.takes("--quick", words.quick, "A first look: 32 steps of the scenario, few others beside it, once each");
  verb.takes("--halvings", words.options.halvings, "N", natural(1, 10),
             "How often the longest time step is halved; it is twice the scenario's smallest");
  verb.takes("--rounds", words.options.rounds, "N", natural(1, 100), "Runs of each setting, to measure the CPU time");
  verb.takes("--out", words.out, "FOLDER", "Folder for results");
  verb.takes("-o,--output", words.picture, "FILE", pictureName("accuracy", true),
             "The chart, a .png, .svg or .pdf; default: the scenario's name in the folder");
  add(verb, words.input);
  add(verb, words.scene);
  add(verb, words.execution);
  add(verb, words.output);
  verb.excludes("--into-golden", {"--output", "--set", "--seed", "--target"},
                "it is the error of the scenario as it is, and nothing is drawn");
  verb.excludes("--quick", {"--into-golden", "--target"}, "--quick is a first look");
  verb.excludes("--stated",
                {"--until", "--target", "--integrator", "--level", "--bullet", "--into-golden", "--budget", "--only",
                 "--quick", "--halvings", "--rounds", "--output", "--set", "--seed", "--json"},
                "--stated prints what golden files say, as Markdown, and computes nothing");
}

}  // namespace morula::cli
