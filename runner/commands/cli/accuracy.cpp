// morula accuracy: speed against error, over time steps, integrators, meshes, precisions, contact laws and
// cell models.
#include "accuracy/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "accuracy/into_golden.h"
#include "accuracy/target.h"
#include "base/error.h"
#include "base/number_text.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "loop/simulate.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/picture_name.h"
#include "options/program.h"
#include "options/verb.h"
#include "pictures/pictures.h"
#include "simulation/world.h"
#include "system/child_process.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct AccuracyWords {
  std::string until, target, halvings = "4", rounds = "3", budget = "120", out = "results", picture;
  std::vector<std::string> scenarios, integrators, levels;
  bool only = false, intoGolden = false, bullet = false, quick = false;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
};

std::vector<Integrator> integrators(const std::vector<std::string>& words) {
  const auto all = valuesOf<Integrator>();
  if (words.empty()) return {all.begin(), all.end()};
  std::vector<Integrator> list;
  for (const auto& word : words) {
    const auto* found = std::ranges::find(all, word, nameOf<Integrator>);
    if (found == all.end())
      throw UsageError("--integrator: '" + word + "' is no integrator; needs " + namesOf<Integrator>());
    list.push_back(*found);
  }
  return list;
}

/// The next coarser mesh, unless others are asked for.
std::vector<std::uint64_t> levels(const AccuracyWords& words, const Scenario& scenario) {
  std::vector<std::uint64_t> list;
  for (const auto& word : words.levels) list.push_back(naturalOption("--level", word, 0, 4));
  const auto own = scenario.mesh.icosphere;
  if (words.levels.empty() && !words.only && !scenario.mesh.file &&
      !(scenario.scene.mechanics && scenario.scene.mechanics->physics.coarsen) && own && *own > 1)
    list.push_back(*own - 1);
  return list;
}

/// [time] That 32 of the scene's first steps take, or all of them. A scene may stop at a number of cells.
double quickTime(World world) {
  for (int i = 0; i < 32 && !finished(world); ++i) step(world);
  return world.clock.time;
}

AccuracyOptions meant(const AccuracyWords& given, const Scenario& scenario, World start) {
  AccuracyWords words = given;
  if (words.quick) words.only = true, words.halvings = words.rounds = "1";
  AccuracyOptions options;
  if (words.quick) options.until = quickTime(std::move(start));
  if (!words.until.empty()) options.until = positiveOption("--until", words.until);
  options.integrators = integrators(words.integrators);
  options.levels = levels(words, scenario);
  options.otherPrecision = options.otherLaw = options.cheaperModels = !words.only;
  options.bullet = words.bullet;
  options.program = ownProgram();
  options.halvings = static_cast<int>(naturalOption("--halvings", words.halvings, 1, 10));
  options.rounds = static_cast<int>(naturalOption("--rounds", words.rounds, 1, 100));
  options.budget = positiveOption("--budget", words.budget);
  options.brief = words.intoGolden;
  options.execution = execution(words.execution);
  options.tell = [quiet = words.output.quiet](const std::string& text) { tell("accuracy: " + text, quiet); };
  return options;
}

/// Reads one scenario with the changes that were asked for, and further ones.
ReadScenario readerOf(const AccuracyWords& words, const std::string& file) {
  return [&words, file](const std::vector<std::string>& changes) {
    auto all = overrides(words.scene);
    for (const auto& change : changes) {
      const auto path = change.substr(0, change.find('='));
      std::erase_if(all, [&](const Override& o) { return o.path == path; });
      all.push_back(parseOverride(change));
    }
    if (!changes
             .empty()) {  // these are of the scenario as it is; measures may need what a check compares with
      all.push_back(parseOverride("check={}"));
      all.push_back(parseOverride("record.measures=null"));
    }
    return loadScenario(file, all, words.input.allowOutside);
  };
}

/// Where the numbers come from: seconds of CPU time are of one machine.
Json provenance(const Scenario& scenario, const Execution& how) {
  const RunRecord record = recordOf(scenario, how, commandLine());
  Json json = Json::object();
  eachFieldOf({.id = {}, .record = record, .started = {}, .ended = {}, .stateHash = {}, .failure = {}},
              [&](const RunField& field, const std::string& value) {
                if (field.part != RunPart::result && !value.empty()) json[field.label] = value;
              });
  return json;
}

/// One scenario, whose report goes to stdout.
int actOn(const AccuracyWords& words, const std::string& file) {
  const ReadScenario read = readerOf(words, file);
  const Scenario scenario = read({});
  if (words.intoGolden) refuseIntoGolden(scenario);
  World start =
      makeScenarioWorld(scenario, execution(words.execution));  // its mistakes are told with their places
  const auto options = meant(words, scenario, std::move(start));
  if (const auto end = plannedEnd(scenario.scene); options.until && end && *options.until > *end)
    throw UsageError(
        fmt::format("--until: {} is after the scene's end; needs at most {}", words.until, numberText(*end)));
  std::optional<double> target;
  if (!words.target.empty()) target = positiveOption("--target", words.target);
  const auto folder = std::filesystem::path(words.out) / "accuracy";
  makeFolder(folder);
  const auto report = measureAccuracy(read, options);

  auto picture = words.picture;
  if (picture.empty() && !options.brief) picture = (folder / (report.scenario + ".png")).string();
  if (!picture.empty()) writePicture(drawAccuracy(report), picture);
  if (words.intoGolden) writeIntoGolden(scenario, report);
  Json json = words.output.json ? toJson(report, picture) : Json();
  std::string text = words.output.json ? "" : describe(report);
  bool held = true;
  if (target) {
    const TargetQuestion question{*target,          file,           words.scene.set,
                                  words.scene.seed, options.budget, options.program,
                                  folder.string(),  read,           options.tell};
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

/// Several, into their goldens: what has none to state is said, and the others go on.
int actOnAll(const AccuracyWords& words) {
  int code = fine;
  for (const std::string& file : words.scenarios) {
    try {
      const Scenario scenario = loadScenario(file, {}, words.input.allowOutside);
      if (!scenario.scene.mechanics || !scenario.check.fails.empty()) {
        tell("accuracy: " + file +
                 ": left out: " + (scenario.scene.mechanics ? "it must fail" : "it has no bodies"),
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
  checkPictureName("accuracy", words.picture, true);
  if (words.intoGolden && !words.picture.empty())
    throw UsageError("--into-golden: nothing is drawn; remove --output");
  if (words.intoGolden && (!words.scene.set.empty() || !words.scene.seed.empty()))
    throw UsageError("--into-golden: it is of the scenario as it is; remove --set and --seed");
  if (words.intoGolden && !words.target.empty())
    throw UsageError("--into-golden: no settings are tried beside the scenario's own; remove --target");
  if (words.quick && (words.intoGolden || !words.target.empty()))
    throw UsageError("--quick is a first look, and neither for --target nor for --into-golden");
  if (words.scenarios.size() == 1) return actOn(words, words.scenarios.front());
  if (!words.intoGolden || words.output.json)
    throw UsageError("accuracy takes several scenarios only with --into-golden and without --json");
  return actOnAll(words);
}

}  // namespace

void addAccuracy(CLI::App& app, Action& action) {
  auto words = std::make_shared<AccuracyWords>();
  Verb verb(
      app, action, "accuracy",
      "Hold integrators, time steps, meshes, precisions and cell models of a scene against each other: speed "
      "and error");
  verb.needs("scenario", words->scenarios, "FILE", "A scenario file; several with --into-golden");
  verb.takes("--until", words->until, "T", "Compare up to this time; default: before chaos sets in");
  verb.takes("--target", words->target, "ERROR",
             "Name the cheapest settings whose error on the scenario's mesh is no larger, as 1e-2, as a "
             "command that has been run to its end, and what the mesh adds; exit 1 without any");
  verb.takes("--integrator", words->integrators, "NAME,...",
             "Only these beside the scenario's own, as rk4,explicit-euler");
  verb.takes("--level", words->levels, "N,...", "Other icospheres, as 1,3; default: the next coarser one");
  verb.takes("--bullet", words->bullet, "Beside Bullet's soft bodies, where the scene can be put to them");
  verb.takes("--into-golden", words->intoGolden,
             "Write the error of the scenario as it is into its golden file; nothing else is tried");
  verb.takes("--budget", words->budget, "SECONDS",
             "CPU time that runs on finer meshes may take, and those of --target to their ends");
  verb.takes("--only", words->only,
             "No other meshes, precision, contact law or cell model than the scenario's");
  verb.takes("--quick", words->quick,
             "A first look: 32 steps of the scenario, few others beside it, once each");
  verb.takes("--halvings", words->halvings, "N", "Of the longest time step, twice the scenario's smallest");
  verb.takes("--rounds", words->rounds, "N", "Runs of each, for the CPU time");
  verb.takes("--out", words->out, "FOLDER", "Folder for results");
  verb.takes("-o,--output", words->picture, "FILE",
             "The chart, a .png, .svg or .pdf; default: the scenario's name in the folder");
  add(verb, words->input);
  add(verb, words->scene);
  add(verb, words->execution);
  add(verb, words->output);
  verb.does([words] { return act(*words); });
}

}  // namespace morula::cli
