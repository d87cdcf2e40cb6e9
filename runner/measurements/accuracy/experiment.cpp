// The experiment: the choice of the runs and of the references they are compared with.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy/bullet_trial.h"
#include "accuracy/converged_reference.h"
#include "base/error.h"
#include "base/number_text.h"
#include "physics/integrator.h"
#include "simulation/simulation.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

// Max growth of one unit in the last place up to the last comparison; errors grow likewise.
constexpr double maxAmplification = 1e4;
constexpr int finer = 3;           // number of halvings from the finest plotted step to the reference's
constexpr double resolution = 10;  // min ratio of a row's error to the reference's own

/// Returns the number of evenly spread times at which stated errors are measured: fewer for many vertices, since the
/// shapes of all times are held in memory.
int statedSamples(int vertices) { return std::clamp(40000 / std::max(vertices, 1), 64, 128); }

std::string cellText(const CellPath& path) { return path == CellPath{} ? "the egg" : "cell " + path.text(); }

class AccuracyExperiment {
 public:
  AccuracyExperiment(const ReadScenario& read, const AccuracyOptions& options)
      : read_(read), options_(options), scenario_(read({})) {
    refuseWithoutError(scenario_);
    radius_ = scenario_.scene.mechanics->physics.cell.radius;
  }

  AccuracyReport run() {
    report_.scenario = scenario_.scene.name;
    choose();
    runs_.emplace(AccuracyRuns{read_, options_, usual_, times_, report_.times, report_.horizon->events, radius_});
    own_ = ownTrial();
    findReference();
    study_ = studyMeshes(*runs_, scenario_, reference_, options_.levels);
    report_.mesh = study_.error;
    report_.own = judged(own_, "as it is", MeasuredEngine::morula);
    report_.stated = stateErrors(report_, ownDistance(own_), times_);
    if (!options_.brief) addRows();
    report_.rival = findRival(report_.own, report_.rows);
    addRemarks();
    report_.orders = findOrders(report_.rows);
    report_.speeds = findSpeeds(report_.rows, report_.usual);
    report_.bulletSpeeds = compareSpeeds(report_.rows);
    report_.end = plannedEnd(scenario_.scene);
    return std::move(report_);
  }

 private:
  /// Chooses the time steps and the times of comparison.
  void choose() {
    options_.tell("looking for the horizon of chaos");
    Horizon h;
    try {
      h = findHorizon(read_({"physics.precision=double"}).scene, options_.execution, options_.until, maxAmplification);
    } catch (const NumericalError& error) {
      throw InputError(scenario_.file + ": the run with the scenario's own settings fails: " + error.what());
    }
    report_.horizon = h;
    longest_ = 2 * h.minTimeStep;
    const double end = options_.until.value_or(h.end), grid = std::max(longest_, h.maxTimeStep);
    // Rows take steps of up to twice the scene's own; the runs of stated errors take none longer than these.
    times_ = withEventTimes(evenTimes(end, h.maxTimeStep, statedSamples(h.vertices)), h.maxTimeStep, h.events);
    report_.times = options_.brief ? times_ : evenTimes(end, grid, options_.samples);
    times_.insert(times_.end(), report_.times.begin(), report_.times.end());
    sortTimes(times_);
    if (report_.times.empty())
      throw InputError(
          fmt::format("{}: the times up to {} are too short to compare; needs at least {}, twice the "
                      "time step",
                      scenario_.file, numberText(end), numberText(grid)));
    if (h.parted && !options_.until)
      remark(
          fmt::format("chaos: up to {} an error of one unit in the last place has grown {:g} times, as any error "
                      "would; later times are not compared (--until)",
                      numberText(h.end), maxAmplification));
    else if (h.parted)
      remark(
          fmt::format("chaos: from {} on, an error of one unit in the last place has grown more than {:g} times; "
                      "errors up to {} include this growth",
                      numberText(h.end), maxAmplification, numberText(end)));
    usual_ = settingOf(scenario_, longest_);
    report_.usual = seriesName(usual_, usual_);
  }

  Trial ownTrial() const {
    const Setting setting = settingAsItIs(scenario_, report_.horizon->minTimeStep);
    tellOf(setting, "as it is");
    return runs_->trial(setting, options_.brief ? 1 : options_.rounds);
  }

  /// Compares the scenario's own run with the reference at all times, before the first division across another plane.
  RunDistance ownDistance(const Trial& own) const {
    if (!own.failure.empty()) return {};
    const auto other = findDividedElsewhere(own.divisions, reference_.divisions, anotherPlane);
    return compareRuns(own, reference_, radius_,
                       {.before = other ? other->time : INFINITY, .events = report_.horizon->events});
  }

  /// Finds a reference with steps as fine as the rows need. The steps get finer if integrators are unstable with them;
  /// `brief` makes them only as fine as the scenario's own row needs.
  void findReference() {
    constexpr int most = 6;
    for (int halvings = options_.brief ? 1 : options_.halvings;; ++halvings) {
      try {
        reference_ = findTimeReference(*runs_, halvings + finer, *report_.horizon, scenario_.file, report_.reference);
      } catch (const InputError&) {
        if (halvings >= options_.halvings + most) throw;
        continue;
      }
      if (!options_.brief || halvings >= most) return;
      if (judged(own_, "as it is", MeasuredEngine::morula).resolved) return;
      if (8 * reference_.cpuSeconds > options_.budget) return;  // two integrators, three runs each, once finer
    }
  }

  void addRows() {
    for (const Setting& setting : settings()) report_.rows.push_back(rowOf(setting, seriesName(setting, usual_)));
    if (options_.bullet) addBullet();
  }

  /// Returns the longest time step that is stable at the start and divides the times of comparison, power of two or
  /// not; 0 if there is none.
  double longestStable(Setting s) const {
    s.timeStep = longest_;
    try {
      const World world = makeWorld(read_(changesFor(s)).scene, options_.execution);
      const double apart = report_.times.front();
      const double step = apart / std::max(1.0, std::ceil(apart / timeStepLimit(world)));  // any, if all are stable
      for (const double time : report_.times)
        if (std::abs(time / apart - std::round(time / apart)) > 1e-9) return 0;
      return step;
    } catch (const InputError&) { return 0; }  // the rows tell the reason
  }

  void addSeries(std::vector<Setting>& list, Setting s) const {
    // Beside Bullet the steps are as long as Bullet's. With Bullet or another model, the longest stable step is tried,
    // too.
    if (const double step = options_.bullet || s.model ? longestStable(s) : 0; step > longest_) {
      s.timeStep = step;
      list.push_back(s);
    }
    for (int i = options_.bullet ? -bulletDoublings : 0; i <= options_.halvings; ++i) {
      s.timeStep = std::ldexp(longest_, -i);
      if (i >= 0 || areMultiples(report_.times, s.timeStep)) list.push_back(s);
    }
  }

  /// Returns true if the scene chooses its time steps and may use others after the comparison.
  bool stepsChange() const {
    const Horizon& h = *report_.horizon;
    if (scenario_.scene.mechanics->physics.timeStep) return false;
    const auto end = plannedEnd(scenario_.scene);
    return h.minTimeStep < h.maxTimeStep || !end || report_.times.back() < *end - longest_;
  }

  /// Adds shares of the automatic time steps, which follow later cells.
  void addShares(std::vector<Setting>& list) const {
    Setting s = settingAsItIs(scenario_, report_.horizon->minTimeStep);
    for (int i = 0; i < options_.halvings; ++i, s.timeStep /= 2, s.autoShare /= 2) list.push_back(s);
  }

  /// Returns the settings; each varies one property beside the time step.
  std::vector<Setting> settings() const {
    std::vector<Setting> list;
    addSeries(list, usual_);
    if (stepsChange()) addShares(list);
    const auto vary = [&](auto change) {
      Setting s = usual_;
      change(s);
      if (seriesName(s, usual_) != report_.usual) addSeries(list, s);
    };
    for (const Integrator i : options_.integrators) {
      vary([&](Setting& s) {
        s.integrator = i;
        if (s.substeps) s.substeps = 1;
      });
      if (i == Integrator::xpbd) vary([](Setting& s) { s.integrator = Integrator::xpbd, s.substeps = 4; });
    }
    if (usual_.level)
      for (const std::uint64_t level : options_.levels) vary([&](Setting& s) { s.level = level; });
    if (options_.otherPrecision)
      vary([](Setting& s) {
        s.precision = s.precision == Precision::binary64 ? Precision::binary32 : Precision::binary64;
      });
    if (options_.otherLaw && usual_.law)
      vary([](Setting& s) { s.law = s.law == ContactLaw::thesis ? ContactLaw::pair : ContactLaw::thesis; });
    if (options_.cheaperModels) addModels(list);
    return list;
  }

  /// Adds cheaper cell models. XPBD needs shells and the thesis' contact law needs meshes, so these are replaced.
  void addModels(std::vector<Setting>& list) const {
    const MechanicsScene& m = *scenario_.scene.mechanics;
    for (const CellModel model : cheaperThan(m.physics.cell.model)) {
      Setting s = usual_;
      s.model = {model, matchShell(m.physics, m.mesh)};
      if (s.substeps) s.substeps = 1;
      if (kindOf(s.integrator).solvesForces) s.integrator = Integrator::velocityVerlet;
      if (s.law && !kindOf(model).hasMesh) s.law = ContactLaw::pair;
      addSeries(list, s);
    }
  }

  void addBullet() {
    Setting verlet = usual_;  // B1 is as stable as velocity Verlet
    verlet.integrator = Integrator::velocityVerlet;
    const BulletSearch search{longest_,           longestStable(verlet), options_.halvings, report_.times,
                              options_.execution, options_.rounds,       options_.program};
    const auto errorOf = [&](const Trial& t) { return judged(t, "", MeasuredEngine::bulletB1).error; };
    for (const BulletTrial& b : tryBullet(scenario_, search, errorOf, options_.tell))
      report_.rows.push_back(judged(b.trial, b.series, measuredEngine(b.setting.baseline)));
  }

  void tellOf(const Setting& setting, const std::string& series) const {
    options_.tell(fmt::format("{}, time step {}", series, numberText(setting.timeStep)));
  }

  AccuracyRow rowOf(const Setting& setting, const std::string& series) const {
    tellOf(setting, series);
    return judged(runs_->rowTrial(setting, options_.rounds), series, MeasuredEngine::morula);
  }

  AccuracyRow judged(const Trial& t, const std::string& series, MeasuredEngine engine) const {
    AccuracyRow row;
    static_cast<Outcome&>(row) = t;
    row.series = series, row.engine = engine, row.set = changesFor(row.setting);
    if (row.failure.empty()) {
      // A golden's errors end before the first division with another plane; other rows tell it in a note.
      const auto other = options_.brief ? findDividedElsewhere(t.divisions, reference_.divisions, anotherPlane)
                                        : std::optional<DividedElsewhere>();
      const ComparisonLimits limits{.before = other ? other->time : INFINITY, .at = report_.times};
      const RunDistance d = compareRuns(t, reference_, radius_, limits);
      row.partedAt = d.partedAt;
      row.errors = d.worst, row.error = d.error(), row.until = d.until, row.touch = d.touch;
      row.birthTimes = compareBirths(t.born, reference_.born) / scenario_.scene.cycle.length;
      row.resolved = row.error && *row.error >= resolution * report_.reference.left.error;
      row.cut = findDividedElsewhere(t.divisions, reference_.divisions);
      if (row.error) row.parts = partsOf(row, t, limits);
    }
    return row;
  }

  /// Bounds the whole error by the triangle inequality: from the row to the converged solution on its own mesh, and
  /// from there to the solution on the finest mesh.
  ErrorParts partsOf(const AccuracyRow& row, const Trial& t, const ComparisonLimits& limits) const {
    const Setting& s = row.setting;
    ErrorParts parts;
    parts.mesh = study_.error.error();
    if (row.engine != MeasuredEngine::morula || s.model || s.law != usual_.law) {
      parts.model = row.error;
      return parts;
    }
    const Trial* converged = &reference_;
    if (s.level != usual_.level) {
      const auto solved = study_.solved.find(*s.level);
      if (solved == study_.solved.end()) {
        if (parts.mesh) *parts.mesh += *row.error;
        return parts;
      }
      converged = &solved->second;
      parts.mesh = study_.error.errorOf(*s.level);
    }
    if (s.precision == Precision::binary64) {
      parts.time = compareRuns(t, *converged, radius_, limits).error();
      parts.precision = report_.horizon->rounding / radius_;
      return parts;
    }
    Setting twin = s;
    twin.precision = Precision::binary64;
    const Trial wide = runs_->rowTrial(twin, 1);
    if (!wide.failure.empty()) return parts;
    parts.time = compareRuns(wide, *converged, radius_, limits).error();
    parts.precision = compareRuns(t, wide, radius_, limits).error();
    return parts;
  }

  void addRemarks() {
    const AccuracyReference& r = report_.reference;
    if (!r.agrees)
      remark(
          fmt::format("the witness does not agree with the reference: their distance is {:.2g}, and their own "
                      "errors are {:.2g} and {:.2g}",
                      r.distance, r.witnessLeft.error, r.left.error));
    std::size_t below = 0;
    for (const AccuracyRow& row : report_.rows) below += row.error && !row.resolved;
    if (below > 0)
      remark(
          fmt::format("{} of {} errors are below ten times the reference's own, {:.2g}; these errors are marked ~ "
                      "and neither fitted nor interpolated",
                      below, report_.rows.size(), r.left.error));
    addCuts();
  }

  /// Adds one remark for each mother whose plane of division depends on rounding.
  void addCuts() {
    std::map<CellPath, std::vector<DividedElsewhere>> cuts;
    const auto see = [&](const std::optional<DividedElsewhere>& cut) {
      if (cut) cuts[cut->mother].push_back(*cut);
    };
    see(report_.own.cut);
    for (const AccuracyRow& row : report_.rows) see(row.cut);
    for (const auto& [mother, list] : cuts) {
      double angle = 0;
      for (const DividedElsewhere& cut : list) angle = std::max(angle, cut.angle);
      const auto& ratio = list.front().extentRatio;
      remark(fmt::format(
          "{} of {} runs divide {} at {} across another plane than the reference, up to {:.0f} degrees from it{}; {}",
          list.size(), report_.rows.size() + 1, cellText(mother), numberText(list.front().time), angle,
          ratio ? fmt::format(", because its largest extent is {:.4f} times its second largest, so that a small "
                              "difference decides",
                              *ratio)
                : std::string(),
          options_.brief && angle > anotherPlane ? "the error is stated up to the time before"
                                                 : "the errors of these runs are those of another plane, whatever "
                                                   "the time step"));
    }
    if (const auto& cut = study_.error.cut)
      remark(fmt::format(
          "on another mesh {} divides at {} across another plane, {:.0f} degrees from it{}: the mesh's error is "
          "stated up to the time before",
          cellText(cut->mother), numberText(cut->time), cut->angle,
          cut->extentRatio ? fmt::format(" (its two largest extents are {:.4f} to 1)", *cut->extentRatio)
                           : std::string()));
  }

  void remark(std::string text) { report_.remarks.push_back(std::move(text)); }

  const ReadScenario& read_;
  const AccuracyOptions& options_;
  Scenario scenario_;
  double radius_ = 1, longest_ = 0;
  std::vector<double> times_;  // [time] all times of comparison; `report_.times` are those of rows
  Setting usual_;
  std::optional<AccuracyRuns> runs_;
  Trial own_, reference_;  // the scenario's own run, and the solution that runs are compared with
  MeshStudy study_;
  AccuracyReport report_;
};

}  // namespace

void refuseWithoutError(const Scenario& scenario) {
  if (!scenario.scene.mechanics)
    throw InputError(scenario.file + ": physics: a lineage-only scene has no error; needs a physics block");
  if (kindOf(scenario.scene.mechanics->physics.integrator).settles)
    throw InputError(scenario.file + ": physics.integrator: " + nameOf(scenario.scene.mechanics->physics.integrator) +
                     " has no time step whose error could be measured, and no target for "
                     "it; accuracy without --target measures how far from rest settlings end");
}

AccuracyReport measureAccuracy(const ReadScenario& read, const AccuracyOptions& options) {
  return AccuracyExperiment(read, options).run();
}

}  // namespace morula
