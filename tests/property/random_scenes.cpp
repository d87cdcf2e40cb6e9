// Tests random scenes for runs that are wrong but look right.
//
//   random_scenes FIRST LAST [FOLDER]     seeds; what fails is shrunk, and written into the folder
//   random_scenes FILE.yaml               one scene, as if it had been drawn
//   random_scenes print SEED              writes what is drawn
//
// Checks of a scene that ends well and sane: own measures agree (own_oracles.h). Without bodies the lineage is the same
// if genes alone decide. Half the step gives a sane run too, or a reason. Resumed from a checkpoint, with other
// instructions, the run has the same bits. Turned and mirrored copies end turned and mirrored. Energy is not gained
// while no event adds any. Refusals must name a place. Failures are counted by their reason, and their advice is tried.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>

#include "base/error.h"
#include "check/sanity_check.h"
#include "connections/connections.h"
#include "diagnose/diagnose.h"
#include "loop/simulate.h"
#include "observation/body_measures.h"
#include "observation/energy.h"
#include "observation/measures.h"
#include "own_oracles.h"
#include "scenario/parameter_table.h"
#include "scenes_by_chance.h"
#include "simulation/restore.h"
#include "simulation/settle.h"
#include "state/state_hash.h"

using namespace morula;
using namespace morula::chance;

namespace {

constexpr double maxWork = 4e6;   // max vertices times force evaluations of a run: 0.3 s; longer runs are cut short
constexpr double maxGain = 0.05;  // [1] of the energy, as in check/sanity_check.cpp
constexpr std::uint64_t fewSteps = 40;

/// Measures the gain of energy [force·length] since the last event, in worlds that are closed between events.
class EnergyWatch {
 public:
  void see(const World& world) {
    if (!isClosedBetweenEvents(world)) return;
    const Energy now = measureEnergy(world);
    auto cells = std::pair(world.cells.path, world.cells.state);
    const auto ties = world.connections ? world.connections->history.size() + released(world) : 0;
    if (cells != cells_ || ties != ties_ || !begin_) {
      // Forces of newborn cells are computed only in the next step, so the energy is taken from then on.
      begin_.reset();
      if (cells == cells_ && ties == ties_) {
        begin_ = now.total();
        double atRest = 0;
        for (const int slot : world.bodies->slots)
          atRest += world.bodies->parameters.pressure.outside * measureRestVolume(*world.bodies, slot);
        scale_ = std::max(now.total() - 2 * now.adhesion, 0.01 * atRest);
      }
      cells_ = std::move(cells), ties_ = ties;
    } else if (scale_ > 0) {
      gain = std::max(gain, (now.total() - *begin_) / scale_);
    }
  }
  double gain = 0;

 private:
  static std::size_t released(const World& world) {
    return std::ranges::count_if(world.connections->history, [](const ConnectionRecord& c) { return c.released >= 0; });
  }
  std::optional<double> begin_;
  double scale_ = 0;
  std::pair<std::vector<CellPath>, std::vector<StateId>> cells_;  // the state decides how cells stick
  std::size_t ties_ = 0;
};

struct Course {
  std::optional<World> world;
  std::string group;  // the reason without numbers and names, if the run did not end well
  std::string text;   // the full reason
  bool refused = false, stopped = false, sane = false;
  std::string half;  // a checkpoint about halfway
  double gain = 0;   // [1] gain of energy
};

std::string groupOf(std::string text) {
  text = text.substr(0, text.find('\n'));
  static const std::vector<std::pair<std::regex, std::string>> without = {
      {std::regex(R"(^[^ ]*:\d+:\d+: )"), ""},
      {std::regex(R"('[^']*')"), "'…'"},
      {std::regex(R"(\b(cell )?(the egg|/?[AB]+)\b)"), "a cell"},
      {std::regex(R"(-?\d+(\.\d+)?(e[+-]?\d+)?)"), "N"}};
  for (const auto& [what, with] : without) text = std::regex_replace(text, what, with);
  return text.substr(0, 110);
}

double workOf(const World& world, std::uint64_t steps) {
  if (settles(world)) {
    double work = 0;
    for (const SettlingRecord& s : *world.settlings) work += static_cast<double>(s.evaluations);
    return work * world.bodies->livingVertices;
  }
  return static_cast<double>(steps) * world.bodies->livingVertices * (1 + world.stages.furtherDrifts.size()) *
         static_cast<double>(world.bodies->parameters.substeps.value_or(1));
}

Execution ownExecution() { return {.isa = bestIsa(), .threads = 1, .memoryLimit = 4e8}; }

/// Runs to the end, or to `lastStep`.
Course run(const Scenario& scenario, bool diagnoses = false, std::optional<std::uint64_t> lastStep = {}) {
  Course course;
  try {
    course.world = makeScenarioWorld(scenario, ownExecution());
  } catch (const InputError& e) {
    course.refused = true, course.text = e.what(), course.group = groupOf(e.what());
    return course;
  }
  World& world = *course.world;
  const SanityCheck sanity(world);
  EnergyWatch energy;
  std::uint64_t keepAt = 8;
  double work = 0;
  try {
    energy.see(world);
    while (!finished(world) && work < maxWork && (!lastStep || world.clock.step < *lastStep)) {
      const std::uint64_t before = world.clock.step;
      takeSteps(world, lastStep ? std::min<std::uint64_t>(16, *lastStep - before) : 16);
      if (world.bodies) work = settles(world) ? workOf(world, 0) : work + workOf(world, world.clock.step - before);
      energy.see(world);
      if (world.clock.step >= keepAt || (settles(world) && world.clock.step == 2))
        course.half = saveState(world), keepAt = world.clock.step * 2;
    }
    stateHash(world);
  } catch (const NumericalError& e) {
    course.stopped = true;
    course.text = e.what();
    const auto* body = dynamic_cast<const BodyFailure*>(&e);
    if (body && diagnoses && !settles(world)) course.text = diagnose(world.model, world.execution, *body);
    course.group = groupOf(e.quantity.empty() ? e.what() : e.quantity);
    return course;
  }
  course.gain = energy.gain;
  course.sane = true;
  for (const CheckResult& result : sanity.results(world, scenario.check, true)) {
    if (result.passed && scenario.check.sane) continue;
    if (course.sane) course.text = result.message, course.group = "not sane: " + result.field;
    course.sane = false;
  }
  return course;
}

struct Verdict {
  std::string find;  // a few words that classify the fault of the program
  std::string more;
  Course course;
  bool tooLong = false;
};

/// Returns the max distance [length] of a copy's vertices from their proper places; infinite if other cells live.
double differenceOf(const World& world, const World& copy, const Turn& turn) {
  if (world.cells.path != copy.cells.path || world.clock.step != copy.clock.step) return INFINITY;
  double most = 0;
  for (const CellPath& cell : world.cells.path) {
    const auto one = cellVertices(world, cell), other = cellVertices(copy, cell);
    for (std::size_t v = 0; v < one.size(); ++v) most = std::max(most, norm(turn.place(one[v]) - other[v]));
  }
  return most;
}

/// Returns true if both worlds have the same divisions. The sign of an axis, and the axis of a round cell, belong to
/// the scene and not to its turn; rounding decides the side of a vertex in the plane. A copy that divides otherwise is
/// another scene from then on.
bool dividedAlike(const World& world, const World& copy, const Turn& turn, double tolerance) {
  if (world.divisions.size() != copy.divisions.size()) return false;
  for (std::size_t i = 0; i < world.divisions.size(); ++i)
    if (!(norm(turn.place(world.divisions[i].axis) - copy.divisions[i].axis) <= tolerance) ||
        !(std::abs(world.divisions[i].share - copy.divisions[i].share) <= tolerance * tolerance))
      return false;
  return true;
}

/// [1] The size of rounding errors that have accumulated for a while.
double jitterOf(const Scene& scene) { return scene.mechanics->physics.precision == Precision::binary32 ? 4e-7 : 1e-12; }

/// Returns a copy moved by rounding errors: the distance between such copies measures how chaotic a scene is.
Scene jittered(Scene scene, std::uint64_t copy) {
  Draw draw(scene.seed + copy);
  const double most = jitterOf(scene) * scene.mechanics->physics.cell.radius;
  for (Point& v : scene.mechanics->mesh.vertices)
    v += Vector{draw.between(-most, most), draw.between(-most, most), draw.between(-most, most)};
  return scene;
}

/// Returns how a copy differs; "" if it does not.
std::string wrongWith(const Turn& turn, const Scenario& scenario, const World& end) {
  // Exact copies are compared at the end, others while rounding is small.
  const std::uint64_t last = turn.isExact ? end.clock.step : std::min(end.clock.step, fewSteps);
  const auto changed = [&](Scene scene) {
    Scenario copy = scenario;
    copy.scene = std::move(scene);
    return run(copy, false, last);
  };
  const Course copy = changed(turned(scenario.scene, turn));
  if (copy.refused) return "is refused: " + copy.text;
  Course own;
  if (!turn.isExact) own = run(scenario, false, last);
  // Returns the allowed distance, by a copy that was moved a little; nothing if this copy stops or divides otherwise.
  const auto boundBy = [&](std::uint64_t number) -> std::optional<double> {
    const Course near = changed(jittered(scenario.scene, number));
    const Turn still{"", [](const Vector& v) { return v; }};
    if (own.stopped || near.stopped || !dividedAlike(*own.world, *near.world, still, 1e-3)) return {};
    return 1e3 * jitterOf(scenario.scene) * end.bodies->parameters.cell.radius +
           100 * differenceOf(*own.world, *near.world, still);
  };
  const std::optional<double> bound = turn.isExact ? 0 : boundBy(0);
  if (!bound) return "";
  const World& world = turn.isExact ? end : *own.world;
  // A copy that divides otherwise is another scene; only divisions of one world alone are wrong.
  const bool alike = dividedAlike(world, *copy.world, turn, turn.isExact ? 0 : 1e-3);
  if (!alike) return world.divisions.empty() != copy.world->divisions.empty() ? "divides otherwise" : "";
  if (copy.stopped) return "stops: " + copy.text;
  const double difference = differenceOf(world, *copy.world, turn);
  if (difference <= *bound) return "";
  // Sticky cells that settle have many states of rest near each other, and one moved copy may reach the same by chance.
  for (std::uint64_t number = 1; !turn.isExact && number < 8; ++number) {
    const std::optional<double> other = boundBy(number);
    if (!other || difference <= *other) return "";
  }
  return fmt::format("is {:.3g} away after {} steps", difference, world.clock.step);
}

std::string wrongAfterResuming(const Scenario& scenario, const Course& course, std::uint64_t seed) {
  if (course.half.empty()) return "";
  Execution other = otherExecution(ownExecution());
  other.threads = seed % 8 == 0 ? 2 : 1;
  World world = makeScenarioWorld(scenario, other);
  restoreState(world, course.half);
  const std::uint64_t from = world.clock.step, end = course.world->clock.step;
  while (world.clock.step < end) takeSteps(world, std::min<std::uint64_t>(7, end - world.clock.step));
  return stateHash(world) == stateHash(*course.world) ? "" : fmt::format("from step {} to {}", from, end);
}

/// Checks that recording does not change results.
std::string wrongWhenRecorded(const Scenario& scenario, const World& end) {
  const Simulation recorded = simulate(scenario, ownExecution(), {.record = recordingOf(scenario, true)});
  if (recorded.end.want != Want::nothing) return "";
  return stateHash(recorded.world) == stateHash(end) ? "" : recorded.end.failure + " and other bits";
}

std::string wrongWithoutBodies(const Scenario& scenario, const World& end) {
  if (!isOfGenesAlone(scenario.scene)) return "";
  Scene scene = scenario.scene;
  scene.mechanics.reset();
  // A run with enough cells ends between the events of one step.
  const auto& enough = scene.stop.cells;
  if (enough && end.cells.path.size() >= *enough) scene.stop = {.cycles = {}, .time = {}, .cells = enough};
  else scene.stop = {.cycles = {}, .time = end.clock.time, .cells = {}};
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  const auto one = familyOf(world), other = familyOf(end);
  if (one == other) return "";
  for (const auto& [path, state] : one)
    if (!other.contains(path)) return fmt::format("cell /{} does not live", path);
    else if (other.at(path) != state) return fmt::format("cell /{} holds {}, not {}", path, other.at(path), state);
  return "more cells live";
}

Course runWithHalfTheStep(const Scenario& scenario, const World& end) {
  Scenario half = scenario;
  PhysicsParameters& p = half.scene.mechanics->physics;
  if (settles(end)) p.settle.tolerance = std::max(1e-12, p.settle.tolerance / 2);
  else if (p.timeStep) *p.timeStep /= 2;
  else p.autoShare /= 2;
  half.scene.stop.time = end.clock.time;
  return run(half);
}

/// Returns a gain of energy that does not fall with the time step. A gain from the time step's error falls; it may be
/// large just after a division.
std::string gainIn(const Course& course, const Course& half) {
  if (!(course.gain > maxGain && half.sane && half.gain > 0.7 * course.gain)) return "";
  return fmt::format("by {:.3g}, and by {:.3g} with half the step", course.gain, half.gain);
}

Verdict judge(const std::string& text, std::uint64_t seed, bool diagnoses) {
  Verdict verdict;
  Scenario scenario;
  const auto find = [&](const char* what, std::string more) {
    if (!more.empty() && verdict.find.empty()) verdict.find = what, verdict.more = std::move(more);
  };
  try {
    try {
      scenario = readScene(text);
    } catch (const InputError& e) {
      verdict.course.refused = true, verdict.course.text = e.what(), verdict.course.group = groupOf(e.what());
    }
    if (!verdict.course.refused) verdict.course = run(scenario, diagnoses);
    Course& course = verdict.course;
    static const std::regex placed("^(" + sceneFile + R"(|\S+:\d+:\d+): [^\n]+)");
    if (course.refused && !std::regex_search(course.text, placed)) find("refused without a place", course.text);
    if (course.refused || course.stopped || !course.world->bodies) return verdict;
    verdict.tooLong = !finished(*course.world);
    if (course.sane) find("called sane and is not", ownVerdict(*course.world));
    find("another lineage than without bodies", wrongWithoutBodies(scenario, *course.world));
    find("other bits after resuming", wrongAfterResuming(scenario, course, seed));
    if (!verdict.tooLong) find("other bits when recorded", wrongWhenRecorded(scenario, *course.world));
    if (!course.sane) return verdict;
    const Course half = runWithHalfTheStep(scenario, *course.world);
    if (half.sane && finished(*half.world)) {
      find("wrong with half the step", ownVerdict(*half.world));
      find("another lineage with half the step", wrongWithoutBodies(scenario, *half.world));
    }
    find("gains energy", gainIn(course, half));
    if (!usesSeed(scenario.scene))
      for (const Turn& turn : turns) find(turn.name, wrongWith(turn, scenario, *course.world));
  } catch (const std::exception& e) { find("an exception", e.what()); }
  return verdict;
}

/// Returns the advice of a message: "KEY VALUE helps", or "use KEY: VALUE".
std::optional<std::pair<std::string, std::string>> adviceIn(const std::string& text) {
  static const std::regex helps(R"(([a-z_]+(?:[.][a-z_-]+)+) ([^ ,;]+) helps)"),
      use(R"(use ([a-z_]+(?:[.][a-z_-]+)+): ([^ ,;]+))");
  std::smatch match;
  if (!std::regex_search(text, match, helps) && !std::regex_search(text, match, use)) return {};
  return std::pair{match[1].str(), match[2].str()};
}

struct Group {
  int count = 0;
  std::map<std::string, int> advised;  // outcomes of scenes that took the advice
  std::string example;
};

struct Tally {
  int sane = 0, cut = 0, finds = 0;
  std::map<std::string, Group> refused, stopped, insane;
  std::set<std::string> drawn;
};

void write(const std::string& folder, std::uint64_t seed, const Verdict& verdict, const Json& smallest) {
  const std::string text =
      fmt::format("# seed {}: {}: {}\n", seed, verdict.find, groupOf(verdict.more)) + sceneText(smallest);
  std::printf("seed %llu: %s: %s\n%s\n", static_cast<unsigned long long>(seed), verdict.find.c_str(),
              verdict.more.c_str(), text.c_str());
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  std::ofstream(std::filesystem::path(folder) / fmt::format("random-{}.yaml", seed)) << text;
}

void see(std::uint64_t seed, const std::string& folder, Tally& tally) {
  const Drawn drawn = drawScene(seed);
  tally.drawn.insert(drawn.keys.begin(), drawn.keys.end());
  const Verdict verdict = judge(sceneText(drawn.scenario), seed, !folder.empty());
  const Course& course = verdict.course;
  tally.cut += verdict.tooLong;
  if (!verdict.find.empty()) {
    ++tally.finds;
    int tries = 0;
    write(folder, seed, verdict, shrink(drawn.scenario, [&](const Json& smaller) {
            return ++tries <= 200 && judge(sceneText(smaller), seed, false).find == verdict.find;
          }));
  }
  if (course.sane) {
    ++tally.sane;
    return;
  }
  auto& groups = course.refused ? tally.refused : course.stopped ? tally.stopped : tally.insane;
  Group& group = groups[course.group];
  if (group.count++ == 0)
    group.example = fmt::format("seed {}: {}", seed, course.text.substr(0, course.text.find('\n')));
  if (const auto advice = adviceIn(course.text)) {
    Json better = drawn.scenario;
    const Json value = tryParseJson(advice->second);
    setKey(better, advice->first, value.is_null() ? Json(advice->second) : value);
    std::string became;
    try {
      const Course course = run(readScene(sceneText(better)));
      became = course.sane ? "sane" : course.group;
    } catch (const InputError& e) { became = groupOf(e.what()); }
    ++group.advised[became];
    if (became != "sane") group.example += "\n        with " + advice->first + " " + advice->second + ": " + became;
  }
}

int print(const char* what, const std::map<std::string, Group>& groups, bool examples) {
  int count = 0;
  std::vector<std::pair<int, std::string>> sorted;
  for (const auto& [name, group] : groups) count += group.count, sorted.push_back({-group.count, name});
  std::ranges::sort(sorted);
  std::printf("%s %d\n", what, count);
  for (const auto& [less, name] : sorted) {
    const Group& group = groups.at(name);
    std::printf("  %4d  %s", group.count, name.c_str());
    int advised = 0;
    for (const auto& [became, times] : group.advised) advised += times;
    const auto sane = group.advised.find("sane");
    if (advised > 0)
      std::printf("; its advice, taken %d times, helped %d", advised, sane == group.advised.end() ? 0 : sane->second);
    std::printf("\n");
    if (examples) std::printf("        %s\n", group.example.c_str());
  }
  return count;
}

/// Checks that shrinking a scene that fails only for its drag leaves nothing else.
bool shrinks() {
  Json scenario = drawScene(1).scenario;
  setKey(scenario, "physics.drag", 3.21);
  const auto fails = [](const Json& s) { return s.value(Json::json_pointer("/physics/drag"), 0.0) > 0.5; };
  return shrink(scenario, fails) == Json{{"physics", {{"drag", 1.0}}}};
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 4096);
  if (argc == 3 && std::string_view(argv[1]) == "print") {
    std::fputs(sceneText(drawScene(std::strtoull(argv[2], nullptr, 10)).scenario).c_str(), stdout);
    return 0;
  }
  if (argc == 2) {
    std::ifstream file(argv[1]);
    const Verdict verdict = judge({std::istreambuf_iterator<char>(file), {}}, 1, true);
    std::printf("%s: %s\n%s\n", verdict.find.c_str(), verdict.more.c_str(), verdict.course.text.c_str());
    return verdict.find.empty() ? 0 : 1;
  }
  if (argc < 3 || argc > 4) return std::fputs("usage: random_scenes FIRST LAST [FOLDER], or FILE.yaml\n", stderr), 2;
  const std::uint64_t first = std::strtoull(argv[1], nullptr, 10), last = std::strtoull(argv[2], nullptr, 10);
  const std::string folder = argc > 3 ? argv[3] : "";
  if (!shrinks()) return std::puts("a scene that fails is not shrunk"), 1;
  Tally tally;
  for (std::uint64_t seed = first; seed <= last; ++seed) see(seed, folder, tally);
  std::printf("sane: %d\n", tally.sane);
  print("not sane, and said so:", tally.insane, !folder.empty());
  print("stopped:", tally.stopped, !folder.empty());
  const int refused = print("refused:", tally.refused, !folder.empty());
  std::printf("cut short: %d\nkeys drawn: %zu of %zu\nfinds: %d\n", tally.cut, tally.drawn.size(),
              scenario::parameterTable().parameters.size(), tally.finds);
  // Scenes that never run well would prove nothing.
  const int count = static_cast<int>(last - first + 1);
  return tally.finds == 0 && tally.sane >= count / 4 && refused <= count / 2 ? 0 : 1;
}
