#include "accuracy/accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/bullet_trial.h"
#include "accuracy/cheaper_model.h"
#include "base/error.h"
#include "base/maths.h"
#include "base/number_text.h"
#include "simulation/stages.h"

namespace morula {

namespace {

// One unit in the last place may have grown so much up to the last comparison: errors do the same.
constexpr double mostAmplification = 1e4;
constexpr int finer = 3;           // halvings from the finest step plotted to the reference's
constexpr double resolution = 10;  // times that the reference must be better than what it judges

/// Multiples of the longest step, evenly up to the end.
std::vector<double> timesUpTo(double end, double longestStep, int samples) {
  const auto steps = static_cast<std::int64_t>(end / longestStep * (1 + 1e-12));
  std::vector<double> times;
  for (int i = 1; i <= samples; ++i) {
    const double time = static_cast<double>(steps * i / samples) * longestStep;
    if (time > (times.empty() ? 0 : times.back())) times.push_back(time);
  }
  return times;
}

/// Largest error up to where other cells live.
struct Comparison {
  std::optional<StateError> errors;
  std::optional<double> partedAt;
};

Comparison compare(const Trial& trial, const Trial& reference, double eggRadius) {
  Comparison c;
  for (std::size_t i = 1; i < reference.shapes.size() && i < trial.shapes.size(); ++i) {
    if (!haveSameCells(trial.shapes[i], reference.shapes[i])) {
      c.partedAt = reference.shapes[i].time;
      break;
    }
    const StateError now = compareShapes(trial.shapes[i], reference.shapes[i], eggRadius);
    c.errors = c.errors ? larger(*c.errors, now) : now;
  }
  return c;
}

double distance(const Trial& a, const Trial& b, double eggRadius) {
  if (!a.failure.empty() || !b.failure.empty()) return INFINITY;
  const Comparison c = compare(a, b, eggRadius);
  return c.partedAt || !c.errors ? INFINITY : c.errors->largest();
}

/// A run with the finest step, and what is left of its error.
struct Converged {
  Trial trial;
  LeftError left;
};

class Experiment {
 public:
  Experiment(const ReadScenario& read, const AccuracyOptions& options)
      : read_(read), options_(options), scenario_(read({})) {
    if (!scenario_.scene.mechanics)
      throw InputError(scenario_.file +
                       ": physics: a lineage-only scene has no error; needs a physics block");
    radius_ = scenario_.scene.mechanics->physics.cell.radius;
  }

  AccuracyReport run() {
    report_.scenario = scenario_.scene.name;
    choose();
    findReference();
    report_.own = rowOf(settingAsItIs(scenario_, report_.horizon->leastTimeStep), "as it is");
    for (const Setting& setting : settings())
      report_.rows.push_back(rowOf(setting, seriesName(setting, usual_)));
    if (options_.bullet) addBullet();
    report_.rival = findRival(report_.own, report_.rows);
    addRemarks();
    report_.orders = findOrders(report_.rows);
    report_.speeds = findSpeeds(report_.rows, report_.usual);
    report_.bulletSpeeds = compareSpeeds(report_.rows);
    return std::move(report_);
  }

 private:
  /// The time steps, and the times of comparison.
  void choose() {
    options_.tell("looking for the horizon of chaos");
    Horizon h;
    try {
      h = findHorizon(read_({"physics.precision=double"}).scene, options_.execution, options_.until,
                      mostAmplification);
    } catch (const NumericalError& error) {
      throw InputError(scenario_.file + ": with its own settings it fails: " + error.what());
    }
    report_.horizon = h;
    longest_ = 2 * h.leastTimeStep;
    const double end = options_.until.value_or(h.end);
    report_.times = timesUpTo(end, std::max(longest_, h.mostTimeStep), options_.samples);
    if (report_.times.empty())
      throw InputError(
          fmt::format("{}: there is nothing to compare up to {}: it is less than {}, twice the time step",
                      scenario_.file, numberText(end), numberText(std::max(longest_, h.mostTimeStep))));
    if (h.parted && !options_.until)
      report_.remarks.push_back(
          fmt::format("chaos: up to {} one unit in the last place has grown {:g} times, as any error would; "
                      "what comes later is "
                      "not compared (--until)",
                      numberText(h.end), mostAmplification));
    else if (h.parted)
      report_.remarks.push_back(
          fmt::format("chaos: from {} on, one unit in the last place has grown more than {:g} times; errors "
                      "up to {} are made of "
                      "that too",
                      numberText(h.end), mostAmplification, numberText(end)));
    usual_ = settingOf(scenario_, longest_);
    report_.usual = seriesName(usual_, usual_);
  }

  Trial trial(const Setting& setting, int rounds) const {
    return runTrial(read_, setting, report_.times, options_.execution, rounds);
  }

  Converged converge(Integrator integrator) const {
    Setting s = usual_;
    s.integrator = integrator;
    if (s.substeps) s.substeps = 1;
    s.precision = Precision::binary64;
    s.timeStep = std::ldexp(longest_, -options_.halvings - finer);
    options_.tell(fmt::format("reference by {}, time step {}", name(integrator), numberText(s.timeStep)));
    Setting middle = s, coarse = s;
    middle.timeStep *= 2, coarse.timeStep *= 4;
    Converged c{trial(s, 1), {}};
    if (!c.trial.failure.empty()) return {c.trial, {INFINITY, 0}};
    const Trial m = trial(middle, 1);
    const double fine = distance(m, c.trial, radius_);
    c.left = estimateByRichardson(distance(trial(coarse, 1), m, radius_), fine, orderOf(integrator));
    return c;
  }

  void findReference() {
    Converged a = converge(Integrator::rungeKutta4), b = converge(Integrator::velocityVerlet);
    if (b.left.error < a.left.error) std::swap(a, b);
    if (!a.trial.failure.empty())
      throw InputError(scenario_.file + ": there is no reference: " + a.trial.failure);
    AccuracyReference& r = report_.reference;
    r.setting = a.trial.setting, r.witness = b.trial.setting;
    r.left = a.left, r.witnessLeft = b.left;
    r.distance = distance(b.trial, a.trial, radius_);
    // Rounding is an error too; beyond the horizon an estimate that looks good does so by chance.
    r.left.error = std::max(r.left.error, report_.horizon->rounding / radius_);
    if (report_.horizon->parted && options_.until) r.left.error = std::max(r.left.error, r.distance);
    r.agrees = r.distance <= 2 * (r.left.error + r.witnessLeft.error);
    reference_ = std::move(a.trial);
  }

  /// The longest time step that is stable at the start and fits into the times of comparison a whole number
  /// of times, power of two or not; 0 if there is none.
  double longestStable(Setting s) const {
    s.timeStep = longest_;
    try {
      const World world = makeWorld(read_(changesFor(s)).scene, options_.execution);
      const double apart = report_.times.front();
      const double step =
          apart / std::max(1.0, std::ceil(apart / timeStepLimit(world)));  // any, if all are stable
      for (const double time : report_.times)
        if (std::abs(time / apart - std::round(time / apart)) > 1e-9) return 0;
      return step;
    } catch (const InputError&) { return 0; }  // the rows tell why
  }

  void addSeries(std::vector<Setting>& list, Setting s) const {
    // Beside Bullet as long ones as Bullet is tried with. There, and with a model that may bear longer steps,
    // the longest of all: who can take them takes them.
    if (const double step = options_.bullet || s.model ? longestStable(s) : 0; step > longest_) {
      s.timeStep = step;
      list.push_back(s);
    }
    for (int i = options_.bullet ? -bulletDoublings : 0; i <= options_.halvings; ++i) {
      s.timeStep = std::ldexp(longest_, -i);
      if (i >= 0 || areMultiples(report_.times, s.timeStep)) list.push_back(s);
    }
  }

  /// One thing is varied at a time, beside the time step.
  std::vector<Setting> settings() const {
    std::vector<Setting> list;
    addSeries(list, usual_);
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
      vary([](Setting& s) { s.law = s.law == ContactLaw::pair ? ContactLaw::thesis : ContactLaw::pair; });
    if (options_.cheaperModels) addModels(list);
    return list;
  }

  /// XPBD is for shells, and the thesis' contact law for meshes.
  void addModels(std::vector<Setting>& list) const {
    const MechanicsScene& m = *scenario_.scene.mechanics;
    for (const CellModel model : cheaperThan(m.physics.cell.model)) {
      Setting s = usual_;
      s.model = {model, matchShell(m.physics, m.mesh)};
      if (s.substeps) s.substeps = 1;
      if (s.integrator == Integrator::xpbd) s.integrator = Integrator::velocityVerlet;
      if (s.law && model == CellModel::sphere) s.law = ContactLaw::pair;
      addSeries(list, s);
    }
  }

  void addBullet() {
    Setting verlet = usual_;  // B1 is as stable
    verlet.integrator = Integrator::velocityVerlet;
    const BulletSearch search{longest_,           longestStable(verlet), options_.halvings, report_.times,
                              options_.execution, options_.rounds,       options_.program};
    const auto errorOf = [&](const Trial& t) { return judged(t, "").error; };
    for (const BulletTrial& b : tryBullet(scenario_, search, errorOf, options_.tell)) {
      report_.rows.push_back(judged(b.trial, b.series));
      report_.rows.back().engine = std::string("bullet-") + name(b.setting.baseline);
    }
  }

  AccuracyRow rowOf(const Setting& setting, const std::string& series) const {
    options_.tell(fmt::format("{}, time step {}", series, numberText(setting.timeStep)));
    return judged(trial(setting, options_.rounds), series);
  }

  AccuracyRow judged(const Trial& t, const std::string& series) const {
    AccuracyRow row;
    row.setting = t.setting;
    row.series = series;
    row.failure = t.failure;
    row.cpuSeconds = t.cpuSeconds;
    row.steps = t.steps, row.forceEvaluations = t.forceEvaluations, row.vertexSteps = t.vertexSteps;
    if (row.failure.empty()) {
      const Comparison c = compare(t, reference_, radius_);
      row.partedAt = c.partedAt;
      if (c.errors) row.errors = *c.errors, row.error = c.errors->largest();
      row.birthTimes = compareBirths(t.born, reference_.born) / scenario_.scene.cycle.length;
      row.resolved = row.error && *row.error >= resolution * report_.reference.left.error;
    }
    return row;
  }

  void addRemarks() {
    const AccuracyReference& r = report_.reference;
    if (!r.agrees)
      report_.remarks.push_back(
          fmt::format("the witness does not agree with the reference: they are {:.2g} apart, and their own "
                      "errors are {:.2g} and "
                      "{:.2g}",
                      r.distance, r.witnessLeft.error, r.left.error));
    std::size_t below = 0;
    for (const AccuracyRow& row : report_.rows) below += row.error && !row.resolved;
    if (below > 0)
      report_.remarks.push_back(
          fmt::format("{} of {} errors are below ten times the reference's own, {:.2g}: they are marked ~ "
                      "and neither fitted nor "
                      "interpolated",
                      below, report_.rows.size(), r.left.error));
  }

  const ReadScenario& read_;
  const AccuracyOptions& options_;
  Scenario scenario_;
  double radius_ = 1, longest_ = 0;
  Setting usual_;
  Trial reference_;
  AccuracyReport report_;
};

bool counts(const AccuracyRow& row) { return row.error && row.resolved && !row.partedAt; }

/// Rows by series, in the order in which they first come.
std::vector<std::vector<const AccuracyRow*>> bySeries(const std::vector<AccuracyRow>& rows) {
  std::vector<std::vector<const AccuracyRow*>> groups;
  for (const AccuracyRow& row : rows) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& g) { return g.front()->series == row.series; });
    if (group == groups.end()) groups.push_back({&row});
    else group->push_back(&row);
  }
  return groups;
}

std::vector<WorkPoint> work(const std::vector<const AccuracyRow*>& series, bool seconds) {
  std::vector<WorkPoint> points;
  // A row that does not count breaks the line: nothing is interpolated across it.
  for (const AccuracyRow* row : series)
    points.push_back(
        {seconds ? row->cpuSeconds : double(row->forceEvaluations), counts(*row) ? *row->error : 0});
  return points;
}

}  // namespace

AccuracyReport measureAccuracy(const ReadScenario& read, const AccuracyOptions& options) {
  return Experiment(read, options).run();
}

const AccuracyRow* cheapest(const AccuracyReport& report, double target) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& row : report.rows)
    if (row.engine == "morula" && row.error && !row.partedAt &&
        *row.error + report.reference.left.error <= target && (!best || row.cpuSeconds < best->cpuSeconds))
      best = &row;
  return best;
}

namespace {

/// Between neighbouring runs, or of one that is more exact and not dearer.
std::optional<double> leastSeconds(const std::vector<const AccuracyRow*>& series, double error) {
  std::optional<double> least = costAtError(work(series, true), error);
  for (const AccuracyRow* row : series)
    if (row->error && !row->partedAt && *row->error <= error && (!least || row->cpuSeconds < *least))
      least = row->cpuSeconds;
  return least;
}

}  // namespace

std::optional<Rival> findRival(const AccuracyRow& own, const std::vector<AccuracyRow>& rows) {
  std::optional<Rival> best;
  const auto offer = [&](const std::string& series, double seconds) {
    if (!best || seconds < best->cpuSeconds) best = {series, seconds, own.cpuSeconds / seconds};
  };
  if (!own.error || own.partedAt) return best;
  for (const auto& series : bySeries(rows)) {
    const auto seconds = leastSeconds(series, *own.error);
    if (seconds && series.front()->engine == "morula") offer(series.front()->series, *seconds);
  }
  return best;
}

std::vector<BulletSpeed> compareSpeeds(const std::vector<AccuracyRow>& rows) {
  std::vector<BulletSpeed> speeds;
  const auto groups = bySeries(rows);
  for (int decade = -1; decade >= -12; --decade) {
    BulletSpeed s;
    s.error = std::pow(10.0, decade);
    for (const auto& series : groups) {
      const auto seconds = leastSeconds(series, s.error);
      if (!seconds) continue;
      const bool own = series.front()->engine == "morula";
      if (!own) s.bulletMostSeconds = std::max(s.bulletMostSeconds, *seconds);
      double& least = own ? s.ourSeconds : s.bulletSeconds;
      if (least > 0 && least <= *seconds) continue;
      least = *seconds;
      (own ? s.ours : s.bullets) = series.front()->series;
    }
    if (s.ourSeconds > 0 && s.bulletSeconds > 0) speeds.push_back(s);
  }
  return speeds;
}

std::vector<SeriesOrder> findOrders(const std::vector<AccuracyRow>& rows) {
  std::vector<SeriesOrder> orders;
  for (const auto& series : bySeries(rows)) {
    std::vector<XY> points;
    for (const AccuracyRow* row : series)
      if (counts(*row)) points.push_back({row->setting.timeStep, *row->error});
    orders.push_back(
        {series.front()->series, orderOf(series.front()->setting.integrator), fitPowerLaw(points)});
  }
  return orders;
}

std::vector<SpeedAtError> findSpeeds(const std::vector<AccuracyRow>& rows, const std::string& usual) {
  std::vector<SpeedAtError> speeds;
  const auto groups = bySeries(rows);
  for (int decade = -1; decade >= -12; --decade) {
    const double error = std::pow(10.0, decade);
    std::optional<double> own;
    for (const auto& series : groups)
      if (series.front()->series == usual) own = costAtError(work(series, true), error);
    for (const auto& series : groups) {
      const auto seconds = costAtError(work(series, true), error),
                 evaluations = costAtError(work(series, false), error);
      if (!seconds || !evaluations) continue;
      speeds.push_back({error, series.front()->series, *seconds, *evaluations,
                        own ? std::optional(*own / *seconds) : std::nullopt});
    }
  }
  return speeds;
}

}  // namespace morula
