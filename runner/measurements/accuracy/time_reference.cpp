// The reference in time: Runge–Kutta and velocity Verlet, each with Richardson's estimate of its remaining error.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "accuracy/converged_reference.h"
#include "base/error.h"
#include "base/number_text.h"
#include "physics/integrator.h"

namespace morula {
namespace {

/// A run with the finest step, and its remaining error.
struct Converged {
  Trial trial;
  LeftError left;
};

/// Returns the distance at the times of rows; infinite if a run fails or other cells live.
double distance(const AccuracyRuns& runs, const Trial& a, const Trial& b) {
  if (!a.failure.empty() || !b.failure.empty()) return INFINITY;
  const RunDistance d = compareRuns(a, b, runs.eggRadius, {.at = runs.rowTimes});
  return d.partedAt ? INFINITY : d.error().value_or(INFINITY);
}

Converged converge(const AccuracyRuns& runs, Integrator integrator, int halvings) {
  Setting s = convergent(runs.usual, integrator);
  s.timeStep = std::ldexp(runs.usual.timeStep, -halvings);
  runs.options.tell(fmt::format("reference by {}, time step {}", nameOf(integrator), numberText(s.timeStep)));
  Setting middle = s, coarse = s;
  middle.timeStep *= 2, coarse.timeStep *= 4;
  Converged c{runs.trial(s, 1), {}};
  if (!c.trial.failure.empty()) return {c.trial, {INFINITY, 0}};
  const Trial m = runs.trial(middle, 1);
  const double fine = distance(runs, m, c.trial);
  c.left = estimateByRichardson(distance(runs, runs.trial(coarse, 1), m), fine, kindOf(integrator).order);
  return c;
}

}  // namespace

Setting convergent(Setting s, Integrator integrator) {
  s.integrator = integrator;
  if (s.substeps) s.substeps = 1;
  s.precision = Precision::binary64;
  return s;
}

Trial AccuracyRuns::trial(const Setting& setting, int rounds, double maxSeconds) const {
  return runTrial(read, setting, times, options.execution, rounds, maxSeconds);
}

Trial AccuracyRuns::rowTrial(const Setting& setting, int rounds) const {
  return runTrial(read, setting, rowTimes, options.execution, rounds);
}

Trial findTimeReference(const AccuracyRuns& runs, int halvings, const Horizon& horizon, const std::string& file,
                        AccuracyReference& r) {
  Converged a = converge(runs, Integrator::rungeKutta4, halvings),
            b = converge(runs, Integrator::velocityVerlet, halvings);
  if (b.left.error < a.left.error) std::swap(a, b);
  if (!a.trial.failure.empty()) throw InputError(file + ": no reference could be computed: " + a.trial.failure);
  r.setting = a.trial.setting, r.witness = b.trial.setting;
  r.left = a.left, r.witnessLeft = b.left;
  r.distance = distance(runs, b.trial, a.trial);
  // Rounding is an error, too. Beyond the horizon a small estimate may be chance.
  r.left.error = std::max(r.left.error, horizon.rounding / runs.eggRadius);
  if (horizon.parted && runs.options.until) r.left.error = std::max(r.left.error, r.distance);
  r.agrees = r.distance <= 2 * (r.left.error + r.witnessLeft.error);
  return std::move(a.trial);
}

}  // namespace morula
