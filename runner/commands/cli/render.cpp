// morula render: pictures of a scenario, or of a stored run, at any time of its life; and how different two look.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "base/error.h"
#include "cli/render_options.h"
#include "cli/verbs.h"
#include "comparison/organism_pair.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/verb.h"
#include "organism/camera.h"
#include "pictures/pictures.h"
#include "system/console.h"
#include "views/compare_pictures.h"
#include "views/film.h"

namespace morula::cli {
namespace {

[[noreturn]] void failAfterEnd(double time, double end) {
  throw UsageError(
      fmt::format("--time: {} is after the end of the run, {:.6g}; needs at most that", exactText(time), end));
}

/// Pictures of the world while it runs, evenly from the start to the planned end.
class Times : public Observer {
 public:
  Times(PictureMaker& maker, int count, double end) : maker_(maker), count_(count), end_(end) {}
  void see(const World& world) override {
    while (next_ < count_ && world.clock.time >= dueTime()) maker_.add(world), ++next_;
  }
  std::uint64_t stepsUntilDue(const World& world) const override {
    return world.bodies && next_ < count_ ? stepsUntil(world.clock, dueTime()) : neverDue;
  }

 private:
  /// [time] With a tolerance far below the time between two pictures: the last step may end a rounding before the end.
  double dueTime() const { return next_ * end_ / (count_ - 1) * (1 - 1e-9); }

  PictureMaker& maker_;
  int count_, next_ = 0;
  double end_;
};

Drawing drawingOf(const OrganismPicture& picture, PictureStyle style) {
  if (style == PictureStyle::both) return organismDrawing(picture, {Style::solid, Style::wireframe});
  return organismDrawing(picture, {style == PictureStyle::wireframe ? Style::wireframe : Style::solid});
}

std::vector<std::string> writeOrganism(const Pictures& pictures, const RenderOptions& options,
                                       const std::string& file) {
  std::optional<OrganismPicture> turned;
  std::vector<Camera> cameras;
  if (options.turntable) {
    turned = pictures[0];
    cameras = turntable(*turned, options.turntable);
  }
  const std::size_t count = turned ? cameras.size() : pictures.size();
  const auto draw = [&](std::size_t i) {
    if (!turned) return drawingOf(pictures[i], options.style).pixels();
    turned->camera = cameras[i];
    return drawingOf(*turned, options.style).pixels();
  };
  if (isFilmName(file)) {
    writeFilm(count, draw, options.perSecond.value_or(25), file);
    return {file};
  }
  if (options.moves()) return writeSequence(count, draw, file);
  writePicture(drawingOf(pictures[0], options.style), file);
  return {file};
}

std::vector<std::string> drawTree(const World& world, const Scenario& scenario, const RenderOptions& options,
                                  const std::string& file) {
  auto tree = lineagePictureOf(world, scenario);
  options.figure.both().set(tree, figureText);
  writePicture(drawLineage(tree), file);
  return {file};
}

/// A scenario that was run as far as the options ask.
struct Shown {
  std::unique_ptr<const Scenario> scenario;  // at a fixed address: pictures refer to it
  std::optional<Simulation> run;
  int code = fine;  // else the program's exit code, without anything to show
};

/// Runs a scenario or a stored run as far as asked for. `observerOf` makes an observer for the scenario and the planned
/// end or --time [time]; null for none.
Shown show(const std::string& file, const RenderOptions& options,
           const std::function<Observer*(const Scenario&, std::optional<double>)>& observerOf) {
  const bool isTree = options.style == PictureStyle::lineage;
  // Positions are not stored: running again gives the same bits.
  Shown shown{std::make_unique<const Scenario>(
                  anyScenario(file, file == options.file ? options.run : "", options.input.allowOutside)),
              {}};
  const Scenario& scenario = *shown.scenario;
  if (!scenario.scene.mechanics && !isTree)
    throw UsageError("--style: " + scenario.scene.name + " has no bodies; needs lineage");
  const auto planned = plannedEnd(scenario.scene);
  const auto& time = options.time;
  if (time && planned && *time > *planned) failAfterEnd(*time, *planned);
  World world = makeScenarioWorld(scenario, execution(options.execution));
  if (time)
    world.model.stop.time = time;  // of the world, not of the scenario: it runs as it always does, only not so far
  RunOptions running{.quiet = options.messages.quiet};
  if (Observer* const observer = observerOf(scenario, time ? time : planned)) running.watch = {observer};
  shown.run = simulate(scenario, std::move(world), running);
  const Simulation& run = *shown.run;
  if (run.end.status == RunStatus::failed) {
    tellError(run.end.failure);
    shown.code = numerical;
  }
  // A run may end before its planned end by its number of cells, or by the death of all.
  else if (time && run.world.bodies && run.end.time < *time * (1 - 1e-9))
    failAfterEnd(*time, run.end.time);
  return shown;
}

/// Draws two runs at one moment side by side, with the distance of their surfaces.
int drawBeside(const RenderOptions& options, const PictureWishes& wishes, Json& told) {
  std::vector<OrganismPicture> pictures;
  NameOf names;
  double radius = 1;
  for (const std::string& file : {options.file, options.beside}) {
    const Shown shown = show(file, options, [](const Scenario&, std::optional<double>) { return nullptr; });
    if (shown.code != fine) return shown.code;
    PictureMaker maker(*shown.scenario, wishes);
    maker.add(shown.run->world);
    pictures.push_back(maker.take()[0]);
    pictures.back().title += ": " + file;
    if (pictures.size() > 1) continue;
    radius = shown.scenario->scene.mechanics->physics.cell.radius;
    names = shown.scenario->names.function();
  }
  const std::string file = options.output.empty() ? "comparison.png" : options.output;
  const auto named = [&](const std::string& text) { return withNames(text, names); };
  const ComparisonImages images = compareOrganisms(pictures[0], pictures[1], radius, {.named = named});
  if (!images.unmatched.empty()) tell("--beside: " + images.unmatched, options.messages.quiet);
  writePicture(comparisonSheet(images), file);
  told = {{"pictures", {file}}};
  return fine;
}

int render(const RenderOptions& options, const PictureWishes& wishes, Json& told) {
  std::optional<PictureMaker> maker;
  std::optional<Times> times;
  auto shown = show(options.file, options, [&](const Scenario& scenario, std::optional<double> end) {
    if (wishes.connections && scenario.scene.mechanics && !scenario.scene.mechanics->connections)
      throw UsageError("--connections: no cells of " + scenario.scene.name + " connect; leave it out");
    maker.emplace(scenario, wishes);
    if (options.frames && !end)
      throw UsageError("--frames: " + scenario.scene.name +
                       " ends by its number of cells, at a time that is not known; needs --time TIME, too");
    if (options.frames) times.emplace(*maker, options.frames, *end);
    return times ? &*times : nullptr;
  });
  if (shown.code != fine) return shown.code;
  const std::string name = shown.scenario->scene.name, file = options.output.empty() ? name + ".png" : options.output;
  std::vector<std::string> files;
  if (options.style == PictureStyle::lineage) files = drawTree(shown.run->world, *shown.scenario, options, file);
  else {
    if (!options.frames) maker->add(shown.run->world);
    if (const auto pattern = maker->strangeOpacity())
      throw UsageError("--opacity: no cell in the picture has a substance that fits '" + *pattern +
                       "'; needs another name, or another --time");
    files = writeOrganism(maker->take(), options, file);
  }
  told = {{"scenario", name}, {"time", shown.run->end.time}, {"pictures", files}};
  return fine;
}

/// Tells how different two picture files look, and draws it if asked to.
int compareFiles(const RenderOptions& options) {
  const ComparedPictures compared = comparePictures(options.file, options.compared);
  if (!options.output.empty()) writePicture(drawCompared(compared), options.output);
  Json json = toJson(compared.difference);
  if (!options.output.empty()) json["pictures"] = {options.output};
  printEither(options.messages, json,
              compared.words + (options.output.empty() ? "" : "picture  " + options.output + "\n"));
  return compared.difference.isNoticeable() ? differs : fine;
}

int act(const RenderOptions& options) {
  const PictureWishes wishes = wishesOf(options);
  checkOutput(options);
  if (!options.compared.empty()) return compareFiles(options);
  Json told;
  const int code = options.beside.empty() ? render(options, wishes, told) : drawBeside(options, wishes, told);
  if (code != fine) return code;
  if (options.messages.json) printJson(told);
  else
    for (const Json& file : told["pictures"]) print(file.get<std::string>() + "\n");
  return fine;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
  Verb verb(app, action, "render",
            "Draw a scenario or a stored run, at its end or another time, still or moving; or compare two pictures");
  auto& options = verb.does<RenderOptions>(act);
  add(verb, options);
}

}  // namespace morula::cli
