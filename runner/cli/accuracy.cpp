// morula accuracy: speed against error, over time steps, integrators, meshes, precisions, contact laws and
// cell models.
#include "accuracy/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "accuracy/cheaper_model.h"
#include "accuracy/picture.h"
#include "accuracy/table.h"
#include "base/number_text.h"
#include "cli/console.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/pictures.h"
#include "cli/simulate.h"
#include "cli/verb.h"
#include "golden/accept.h"
#include "process/child_process.h"

namespace morula::cli {

namespace {

struct AccuracyWords {
  std::string scenario, until, target, halvings = "4", rounds = "3", out = "results";
  std::vector<std::string> integrators, levels;
  bool only = false, intoGolden = false, bullet = false;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
};

std::vector<Integrator> integrators(const std::vector<std::string>& words) {
  if (words.empty()) return {std::begin(allIntegrators), std::end(allIntegrators)};
  std::vector<Integrator> list;
  for (const auto& word : words) {
    const auto* found = std::find_if(std::begin(allIntegrators), std::end(allIntegrators),
                                     [&](Integrator i) { return word == name(i); });
    if (found == std::end(allIntegrators))
      throw UsageError("--integrator: '" + word +
                       "' is no integrator; needs velocity-verlet, thesis-verlet, explicit-euler, "
                       "symplectic-euler, rk4 or xpbd");
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

AccuracyOptions meant(const AccuracyWords& words, const Scenario& scenario) {
  AccuracyOptions options;
  if (!words.until.empty()) options.until = positiveOption("--until", words.until);
  options.integrators = integrators(words.integrators);
  options.levels = levels(words, scenario);
  options.otherPrecision = options.otherLaw = options.cheaperModels = !words.only;
  options.bullet = words.bullet;
  options.program = ownProgram();
  options.halvings = static_cast<int>(naturalOption("--halvings", words.halvings, 1, 10));
  options.rounds = static_cast<int>(naturalOption("--rounds", words.rounds, 1, 100));
  options.execution = execution(words.execution);
  options.tell = [quiet = words.output.quiet](const std::string& text) { tell("accuracy: " + text, quiet); };
  return options;
}

Json toJson(const Setting& s) {
  return {{"integrator", name(s.integrator)},
          {"time_step", s.timeStep},
          {"icosphere", orNull(s.level)},
          {"substeps", s.substeps.value_or(1)},
          {"precision", s.precision == Precision::binary64 ? "double" : "single"},
          {"contact_law", s.law ? Json(*s.law == ContactLaw::pair ? "pair" : "thesis") : Json()},
          {"cell_model", s.model ? Json(name(s.model->model)) : Json()},
          {"set", changesFor(s)}};
}

Json toJson(const AccuracyRow& row) {
  const bool known = row.error.has_value();
  return {{"settings", toJson(row.setting)},
          {"engine", row.engine},
          {"series", row.series},
          {"error", orNull(row.error)},
          {"errors", known ? Json{{"centroid", row.errors.centroid},
                                  {"volume", row.errors.volume},
                                  {"surface", row.errors.surface},
                                  {"birth_times", row.birthTimes}}
                           : Json()},
          {"resolved", row.resolved},
          {"lineages_part_at", orNull(row.partedAt)},
          {"cpu_seconds", row.cpuSeconds},
          {"force_evaluations", row.forceEvaluations},
          {"vertex_steps", row.vertexSteps},
          {"steps", row.steps},
          {"failed", !row.failure.empty()},
          {"failure", row.failure.empty() ? Json() : Json(row.failure)}};
}

/// JSON has no infinity: an error that is not known is null.
Json finite(double a) { return a < 1e300 ? Json(a) : Json(); }

Json toJson(const AccuracyReference& r) {
  return {{"settings", toJson(r.setting)},
          {"own_error", finite(r.left.error)},
          {"observed_order", r.left.order},
          {"witness", toJson(r.witness)},
          {"witness_distance", finite(r.distance)},
          {"witness_own_error", finite(r.witnessLeft.error)},
          {"agrees", r.agrees}};
}

Json toJson(const SeriesOrder& o) {
  return {{"series", o.series},
          {"theory", o.theory},
          {"observed", o.observed ? Json(o.observed->slope) : Json()},
          {"standard_error", o.observed ? Json(o.observed->slopeError) : Json()},
          {"points", o.observed ? o.observed->points : 0}};
}

Json toJson(const AccuracyReport& report, const std::string& picture) {
  Json rows = Json::array(), orders = Json::array(), speeds = Json::array();
  for (const auto& row : report.rows) rows.push_back(toJson(row));
  for (const auto& order : report.orders) orders.push_back(toJson(order));
  Json besideBullet = Json::array();
  for (const auto& s : report.bulletSpeeds)
    besideBullet.push_back({{"error", s.error},
                            {"series", s.ours},
                            {"cpu_seconds", s.ourSeconds},
                            {"bullet_series", s.bullets},
                            {"bullet_cpu_seconds", s.bulletSeconds},
                            {"bullet_slowest_cpu_seconds", s.bulletMostSeconds}});
  for (const auto& s : report.speeds)
    speeds.push_back({{"error", s.error},
                      {"series", s.series},
                      {"cpu_seconds", s.cpuSeconds},
                      {"force_evaluations", s.forceEvaluations},
                      {"speed", orNull(s.speed)}});
  return {{"scenario", report.scenario},
          {"times", report.times},
          {"reference", toJson(report.reference)},
          {"as_it_is", toJson(report.own)},
          {"rival", report.rival ? Json{{"series", report.rival->series},
                                        {"cpu_seconds", report.rival->cpuSeconds},
                                        {"speed", report.rival->speed}}
                                 : Json()},
          {"rows", rows},
          {"orders", orders},
          {"speed_at_error", speeds},
          {"beside_bullet", besideBullet},
          {"remarks", report.remarks},
          {"picture", picture}};
}

std::string join(const std::vector<std::string>& words, const char* before) {
  std::string text;
  for (const auto& word : words) text += before + word;
  return text;
}

std::string targetText(const AccuracyWords& words, const AccuracyReport& report, const AccuracyRow* best,
                       double target) {
  if (!best) return fmt::format("none of the settings tried holds an error of {}\n", numberText(target));
  return fmt::format(
      "the cheapest settings tried that hold an error of {}: {:.2g} in {:.4f} s of CPU time, up to time {}\n"
      "  morula run {}{}{}\n"
      "  nothing later was tried: lighter daughters may not bear this time step\n",
      numberText(target), *best->error, best->cpuSeconds, numberText(report.times.back()), words.scenario,
      join(words.scene.set, " --set ") + (words.scene.seed.empty() ? "" : " --seed " + words.scene.seed),
      join(changesFor(best->setting), " --set "));
}

/// A golden states the error of the scenario as it lies there.
void refuseIntoGolden(const AccuracyWords& words, const Scenario& scenario) {
  if (!words.intoGolden) return;
  if (!words.scene.set.empty() || !words.scene.seed.empty())
    throw UsageError("--into-golden: it is of the scenario as it is; remove --set and --seed");
  const auto file = goldenPath(scenario.file);
  refuseWithinCi(file);
  if (readGoldenFile(file).data.scenarioHash != scenario.meaning.text())
    throw InputError(file.string() + ": the scenario has changed since; accept its result first");
}

void writeIntoGolden(const Scenario& scenario, const AccuracyReport& report) {
  const AccuracyRow& own = report.own;
  if (!own.error || own.partedAt)
    throw InputError(scenario.file + ": it has no error to state: " +
                     (own.failure.empty() ? "its lineage is not the reference's" : own.failure));
  if (report.reference.left.error > *own.error)
    throw InputError(
        fmt::format("{}: it has no error to state: the reference's own is {:.2g} and the scenario's {:.2g}; "
                    "compare a shorter time (--until)",
                    scenario.file, report.reference.left.error, *own.error));
  const auto file = goldenPath(scenario.file);
  Golden golden = readGoldenFile(file);
  // A measured number, not a result: two digits.
  golden.error = {std::stod(fmt::format("{:.1e}", *own.error)), report.times.back()};
  acceptGolden(file, golden, {golden.acceptedBy, golden.why});
}

int act(const AccuracyWords& words) {
  const auto given = overrides(words.scene);
  const ReadScenario read = [&](const std::vector<std::string>& changes) {
    auto all = given;
    for (const auto& change : changes) {
      const auto path = change.substr(0, change.find('='));
      std::erase_if(all, [&](const Override& o) { return o.path == path; });
      all.push_back(parseOverride(change));
    }
    if (!changes.empty()) all.push_back(parseOverride("check={}"));  // it is of the scenario as it is
    return loadScenario(words.scenario, all);
  };
  const Scenario scenario = read({});
  refuseIntoGolden(words, scenario);
  const auto options = meant(words, scenario);
  if (const auto end = plannedEnd(scenario.scene); options.until && end && *options.until > *end)
    throw UsageError(
        fmt::format("--until: {} is after the scene's end; needs at most {}", words.until, numberText(*end)));
  makeScenarioWorld(scenario, options.execution);  // its mistakes are told with their places
  std::optional<double> target;
  if (!words.target.empty()) target = positiveOption("--target", words.target);
  const auto folder = std::filesystem::path(words.out) / "accuracy";
  makeFolder(folder);
  const auto report = measureAccuracy(read, options);

  const auto picture = (folder / (report.scenario + ".png")).string();
  writePng(drawAccuracy(report), picture);
  if (words.intoGolden) writeIntoGolden(scenario, report);
  const AccuracyRow* best = target ? cheapest(report, *target) : nullptr;
  if (words.output.json) {
    Json json = toJson(report, picture);
    if (target) json["target"] = {{"error", *target}, {"settings", best ? toJson(best->setting) : Json()}};
    printJson(json);
  } else {
    print(describe(report) + (target ? "\n" + targetText(words, report, best, *target) : "") + "\npicture  " +
          picture + "\n");
  }
  return target && !best ? differs : fine;
}

}  // namespace

void addAccuracy(CLI::App& app, Action& action) {
  auto words = std::make_shared<AccuracyWords>();
  Verb verb(
      app, action, "accuracy",
      "Hold integrators, time steps, meshes, precisions and cell models of a scene against each other: speed "
      "and error");
  verb.needs("scenario", words->scenario, "FILE", "A scenario file");
  verb.takes("--until", words->until, "T", "Compare up to this time; default: before chaos sets in");
  verb.takes("--target", words->target, "ERROR",
             "Name the cheapest settings with no larger error, as 1e-2; exit 1 without any");
  verb.takes("--integrator", words->integrators, "NAME,...",
             "Only these beside the scenario's own, as rk4,explicit-euler");
  verb.takes("--level", words->levels, "N,...", "Other icospheres, as 1,3; default: the next coarser one");
  verb.takes("--bullet", words->bullet, "Beside Bullet's soft bodies, where the scene can be put to them");
  verb.takes("--into-golden", words->intoGolden,
             "Write the error of the scenario as it is into its golden file");
  verb.takes("--only", words->only,
             "No other meshes, precision, contact law or cell model than the scenario's");
  verb.takes("--halvings", words->halvings, "N", "Of the longest time step, twice the scenario's smallest");
  verb.takes("--rounds", words->rounds, "N", "Runs of each, for the CPU time");
  verb.takes("--out", words->out, "FOLDER", "Folder for results");
  add(verb, words->scene);
  add(verb, words->execution);
  add(verb, words->output);
  verb.does([words] { return act(*words); });
}

}  // namespace morula::cli
