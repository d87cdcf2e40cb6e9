#include "bench/bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/packed_world.h"
#include "bench/subject.h"
#include "contacts/contacts.h"
#include "engines/bullet_scene.h"
#include "engines/engine_worker.h"
#include "system/clock.h"

namespace morula {
namespace {

struct PlannedScene {
  PackedScene packed;
  std::string name;
  bool whole;  // true: all measurements; false: only those that the variant of a scene changes
};

constexpr int maxBruteForceVertices = 12'000;  // max size for the brute-force search, whose time grows with the square

class SceneBench {
 public:
  SceneBench(const BenchOptions& options, const PlannedScene& scene)
      : options_(options),
        packed_(scene.packed),
        name_(scene.name),
        whole_(scene.whole),
        everyStage_(whole_ || !packed_.contact || packed_.precision == Precision::binary32),
        isas_(everyStage_ || !packed_.stirred ? options.isas : std::vector{options.isas.back()}),
        bulletProgram_(bulletProgram()),
        subject_(packed_, *std::max_element(options.threads.begin(), options.threads.end()), options.folder,
                 options.tell) {
    // The number of steps depends on the size alone, so that counts of steps are the same on every machine.
    const double wanted = options.stepsFactor * std::max(24.0, 96 * std::min(1.0, 40'000 / subject_.vertices()));
    steps_ = std::max(4, static_cast<int>(wanted));
  }

  void round() {
    for (const Isa isa : isas_) measureStages(isa);
    if (whole_ && wants(Stage::internal))
      series(MeasuredEngine::scalar, Stage::internal, "").samples.push_back(subject_.timeOrdinaryForces());
    if (needsSteps() && subject_.touching()) measureSearches();
    if (whole_ && wants(Stage::step) && options_.threads.size() > 1) measureThreads();
    if (!bulletProgram_.empty() && wants(Stage::step) && packed_.cells <= options_.maxBulletCells) {
      if (bullets_.empty())
        for (const Baseline baseline : {Baseline::b1, Baseline::b2})
          bullets_.emplace_back(baseline, bulletSubject(baseline));
      for (auto& [baseline, bullet] : bullets_) bullet.round();
    }
    // Whole steps count rebuilds and move the state on for the next round.
    if (needsSteps()) measureSteps();
  }

  std::vector<BenchRow> rows() const {
    std::vector<BenchRow> rows;
    for (const Series& s : all_) finish(s, rows);
    for (const auto& [baseline, bullet] : bullets_) finish(bullet, baseline, rows);
    return rows;
  }

 private:
  /// A row being measured: its samples, in seconds per vertex and step.
  struct Series {
    BenchRow row;
    std::vector<double> samples;
    std::vector<double> searches;  // for a step: times of searches, with a choice of pairs, that `samples` leave out
  };

  bool wants(Stage stage) const {
    return std::find(options_.stages.begin(), options_.stages.end(), stage) != options_.stages.end();
  }

  /// Returns the program that runs Bullet in the scene's precision; "" if Bullet is not wanted.
  std::string bulletProgram() const {
    if (!options_.bullet) return "";
    return whole_ ? options_.program : packed_.precision == Precision::binary32 ? options_.singleBullet : "";
  }

  bool needsSteps() const { return wants(Stage::step) || wants(Stage::rebuild) || wants(Stage::choice); }

  BenchRow rowOf(MeasuredEngine engine, Stage stage) const {
    BenchRow row;
    row.scene = name_, row.engine = engine, row.stage = stage;
    row.precision = packed_.precision;
    row.cells = packed_.cells, row.vertices = subject_.world().bodies->vertexCount();
    return row;
  }

  Series& series(MeasuredEngine engine, Stage stage, const std::string& isa, int threads = 1, bool wall = false,
                 const std::string& search = "") {
    for (Series& s : all_)
      if (s.row.engine == engine && s.row.stage == stage && s.row.isa == isa && s.row.threads == threads &&
          s.row.wallClock == wall && s.row.search == search)
        return s;
    Series s;
    s.row = rowOf(engine, stage);
    s.row.isa = isa, s.row.threads = threads, s.row.wallClock = wall, s.row.search = search;
    all_.push_back(std::move(s));
    return all_.back();
  }

  void measureStages(Isa isa) {
    if (wants(Stage::internal) && everyStage_)
      series(MeasuredEngine::morula, Stage::internal, name(isa)).samples.push_back(subject_.timeInternal(isa));
    if (wants(Stage::contact) && subject_.touching())
      series(MeasuredEngine::morula, Stage::contact, name(isa)).samples.push_back(subject_.timeContact(isa));
    if (wants(Stage::integrate) && everyStage_)
      series(MeasuredEngine::morula, Stage::integrate, name(isa)).samples.push_back(subject_.timeIntegration(isa));
  }

  void measureSearches() {
    for (const Isa isa : isas_) {
      const double grid = subject_.timeRebuild(isa, ContactSearch::grid), choice = subject_.timeChoice(isa);
      series(MeasuredEngine::morula, Stage::step, name(isa)).searches.push_back(grid + choice);
      series(MeasuredEngine::morula, Stage::choice, name(isa)).samples.push_back(choice);
      if (wants(Stage::rebuild) && whole_)
        series(MeasuredEngine::morula, Stage::rebuild, name(isa), 1, false, nameOf(ContactSearch::grid))
            .samples.push_back(grid);
    }
    if (!wants(Stage::rebuild) || !whole_) return;
    for (const ContactSearch method : valuesOf<ContactSearch>()) {
      if (method == ContactSearch::grid) continue;
      if (method == ContactSearch::bruteForce && subject_.vertices() > maxBruteForceVertices) continue;
      const Isa isa = isas_.back();
      series(MeasuredEngine::morula, Stage::rebuild, name(isa), 1, false, nameOf(method))
          .samples.push_back(subject_.timeRebuild(isa, method));
    }
  }

  void measureSteps() {
    const int few = std::max(4, steps_ / 4);
    for (const Isa isa : isas_)
      if (isa != isas_.back())
        series(MeasuredEngine::morula, Stage::step, name(isa))
            .samples.push_back(subject_.trySteps(isa, 1, ClockKind::cpu, few));
    const Isa widest = isas_.back();
    series(MeasuredEngine::morula, Stage::step, name(widest)).samples.push_back(subject_.goOn(widest, steps_));
  }

  void measureThreads() {
    const Isa isa = isas_.back();
    for (const int threads : options_.threads) {
      Series& s = series(MeasuredEngine::morula, Stage::step, name(isa), threads, true);
      s.samples.push_back(subject_.trySteps(isa, threads, ClockKind::wall, std::max(4, steps_ / 3)));
      if (subject_.touching())
        s.searches.push_back(subject_.timeRebuild(isa, ContactSearch::grid, ClockKind::wall, threads) +
                             subject_.timeChoice(isa, ClockKind::wall, threads));
      s.row.processors = std::max(s.row.processors.value_or(0), processorsFor(threads));
    }
  }

  BulletSubject bulletSubject(Baseline baseline) const {
    BulletScene scene;
    const Bodies& bodies = *subject_.world().bodies;
    scene.baseline = baseline;
    scene.mesh = bodies.mesh.mesh;
    scene.physics = bodies.parameters;
    scene.timeStep = subject_.world().clock.timeStep;
    // The cells have settled. Morula's world is stirred so that it searches for neighbours; Bullet searches in every
    // step.
    scene.cells = settledBodies(packed_, options_.folder, options_.tell);
    return {scene, shareRadius(packed_.cells),
            [program = bulletProgram_](const BulletRequest& request) { return runInBullet(request, program); }};
  }

  void finish(const BulletSubject& subject, Baseline baseline, std::vector<BenchRow>& rows) const {
    BenchRow row = rowOf(measuredEngine(baseline), Stage::step);
    row.bulletSettings = subject.timings();
    if (row.bulletSettings.empty()) return;
    row.nsPerVertexStep = row.bulletSettings.front().nsPerVertexStep;
    row.spread = spread(row.bulletSettings.front().samples);
    rows.push_back(row);
  }

  double rebuildsPerStep() const {
    const StepCounters& c = subject_.counters();
    return c.steps == 0 ? 0 : static_cast<double>(c.rebuilds) / static_cast<double>(c.steps);
  }

  /// Returns how often pairs of all vertices were chosen, or of as many vertices one by one.
  double choicesPerStep() const {
    const StepCounters& c = subject_.counters();
    return c.steps == 0 ? 0 : static_cast<double>(c.listsThinned) / static_cast<double>(c.steps) / subject_.lists();
  }

  double slotsPerVertex() const {
    const StepCounters& c = subject_.counters();
    if (c.looks == 0) return subject_.touching() ? double(countSlots(*subject_.world().contacts)) / subject_.vertices() : 0;
    return static_cast<double>(c.slots) / static_cast<double>(c.looks) / subject_.vertices();
  }

  double pairsPerVertex() const {
    const StepCounters& c = subject_.counters();
    if (c.steps == 0) return subject_.touching() ? subject_.world().contacts->list.pairs / subject_.vertices() : 0;
    return static_cast<double>(c.pairs) / static_cast<double>(c.steps) / subject_.vertices();
  }

  Work workOf(Stage stage, Isa isa) const {
    const Bodies& bodies = *subject_.world().bodies;
    const Instructions& counted = instructionsOf(isa);
    const bool slides = packed_.viscosity > 0;
    Work internal = internalWork(bodies.mesh, bodies.parameters);
    Work integration = integrationWork(bodies.parameters.shell.has_value());
    Work contact = contactWork(bodies.mesh, slotsPerVertex(), slides);
    internal.instructions = counted.internal;
    integration.instructions = counted.integration;
    contact.instructions = counted.contact + (slides ? counted.perSlidingSlot : counted.perSlot) * slotsPerVertex();
    switch (stage) {
      case Stage::internal: return internal;
      case Stage::contact: return contact;
      case Stage::integrate: return integration;
      default: break;
    }
    Work step = stepWork(internal, subject_.touching() ? &contact : nullptr, integration);
    if (subject_.touching()) step.instructions += rebuildsPerStep() * counted.search + choicesPerStep() * counted.choice;
    else step.instructions = counted.alone;
    return step;
  }

  void finish(const Series& s, std::vector<BenchRow>& rows) const {
    if (s.samples.empty() || !wants(s.row.stage)) return;  // the row was only needed for another
    BenchRow row = s.row;
    // By wall clock time other processes disturb, and a thread that waits for a suspended one counts double. So the
    // shortest sample tells the cost best.
    const auto typical = [&](const std::vector<double>& samples) {
      return row.wallClock ? *std::min_element(samples.begin(), samples.end()) : median(samples);
    };
    double time = typical(s.samples);
    row.spread = spread(s.samples);
    const bool sometimes = row.stage == Stage::rebuild || row.stage == Stage::choice;
    if (sometimes) {
      row.nsPerVertexOnce = 1e9 * time;
      time *= row.stage == Stage::rebuild ? rebuildsPerStep() : choicesPerStep();
    }
    if (!s.searches.empty()) time += rebuildsPerStep() * typical(s.searches);
    row.nsPerVertexStep = 1e9 * time;
    const bool knownLimit = row.precision == Precision::binary64;  // the machine's limits are measured with doubles
    if (row.engine == MeasuredEngine::morula && row.threads == 1 && !sometimes && knownLimit)
      row.work = workOf(row.stage, parseIsa(row.isa));
    const bool goesThroughPairs = row.stage == Stage::step || row.stage == Stage::contact;
    if (row.engine == MeasuredEngine::morula && subject_.touching() && (goesThroughPairs || sometimes)) {
      row.pairsPerVertexStep = pairsPerVertex(), row.slotsPerVertexStep = slotsPerVertex();
      row.rebuildsPerStep = rebuildsPerStep(), row.choicesPerStep = choicesPerStep();
    }
    rows.push_back(row);
  }

  const BenchOptions& options_;
  PackedScene packed_;
  std::string name_;
  bool whole_, everyStage_;
  std::vector<Isa> isas_;
  std::string bulletProgram_;
  Subject subject_;
  int steps_;  // steps of a round
  std::vector<Series> all_;
  std::vector<std::pair<Baseline, BulletSubject>> bullets_;
};

/// Measures a scene, from packing to the last round. Returns all rows, without their shares of the machine's limits.
/// `meter`: takes a sample in every round. Only one scene is in memory at a time.
std::vector<BenchRow> measureScene(const PlannedScene& scene, const BenchOptions& options, LimitMeter& meter) {
  SceneBench bench(options, scene);
  for (int i = 0; i < options.rounds; ++i) {
    options.tell(fmt::format("{} scene, {} cells, level {}: round {} of {}", scene.name, scene.packed.cells,
                             scene.packed.level, i + 1, options.rounds));
    meter.sample();
    bench.round();
  }
  return bench.rows();
}

std::vector<PlannedScene> plan(const BenchOptions& options) {
  std::vector<PlannedScene> scenes;
  for (const int cells : options.cells)
    for (const int level : options.levels) {
      scenes.push_back({{.cells = cells, .level = level}, "packed", true});
      scenes.push_back({{.cells = cells, .level = level, .stirred = false}, "packed-still", false});
      scenes.push_back({{.cells = cells, .level = level, .viscosity = 0.3}, "packed-viscosity", false});
      scenes.push_back({{.cells = cells, .level = level, .precision = Precision::binary32}, "packed-single", false});
      scenes.push_back({{.cells = cells, .level = level, .contact = false}, "free", false});
    }
  for (const int level : options.extraLevels)
    scenes.push_back({{.cells = options.extraCells, .level = level}, "packed", true});
  return scenes;
}

void addShares(BenchRow& row, const MachineLimits& limits) {
  if (!row.work) return;
  const Isa isa = parseIsa(row.isa);
  const double time = 1e-9 * row.nsPerVertexStep;
  row.limit = findLimit(*row.work, limits, isa, double(row.cells) * row.vertices);
  row.shareOfLimit = row.limit->of(row.limit->bound()) / time;
  const auto& peak = limits.arithmetic.at(isa);
  row.shareOfPeak = row.work->operations / peak.operations / time;
  row.shareWithRoots = *row.shareOfPeak + row.work->roots / peak.roots / time;
}

}  // namespace

BenchReport runBench(const BenchOptions& asked) {
  BenchOptions options = asked;
  BenchReport report;
  if (options.bullet && !bulletIsAvailable()) {
    options.bullet = false;
    report.remarks.push_back("Bullet is left out: this program was built without it");
  }
  if (options.bullet && options.singleBullet.empty())
    report.remarks.push_back("Bullet in single precision is left out: it is built with the tests, by ./morula test");
  LimitMeter meter(options.isas);
  for (const PlannedScene& scene : plan(options))
    for (BenchRow& row : measureScene(scene, options, meter)) report.rows.push_back(std::move(row));
  report.machine = meter.limits();
  for (BenchRow& row : report.rows) addShares(row, report.machine);
  report.ratios = findRatios(report.rows);
  return report;
}

const BenchRow* find(const std::vector<BenchRow>& rows, const std::string& scene, MeasuredEngine engine, Stage stage,
                     int cells, int vertices, const std::string& isa, int threads, bool wallClock) {
  for (const BenchRow& row : rows)
    if (row.scene == scene && row.engine == engine && row.stage == stage && row.cells == cells &&
        row.vertices == vertices && row.isa == isa && row.threads == threads && row.wallClock == wallClock)
      return &row;
  return nullptr;
}

}  // namespace morula
