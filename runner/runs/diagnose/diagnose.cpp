#include "diagnose/diagnose.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/number_text.h"
#include "contacts/contacts.h"
#include "diagnose/remedies.h"
#include "diagnose/vertex_forces.h"
#include "observation/body_measures.h"
#include "observation/sanity.h"
#include "physics/stability.h"
#include "simulation/check_bodies.h"
#include "simulation/move_physics.h"
#include "simulation/restore.h"
#include "simulation/run_end.h"
#include "simulation/simulation.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

struct ForceWork {
  // The name: "springs", "contents", "outer pressure", "its shape", "contacts", "connections" or "crawling"
  std::string force;
  double work = 0;  // [force·length] on the cell's vertices; negative: the force resisted
};

/// Sums up, step by step, the work Σ f·Δx of each force on the vertices of one cell; f is the mean of the force at both
/// ends of the step.
class WorkMeter {
 public:
  /// The cell must exist in the world as long as the meter observes.
  WorkMeter(World& world, const CellPath& cell)
      : cell_(cell), before_(positions(world)), forces_(measureForces(world, slotIn(world))) {
    for (const VertexForces& f : forces_) works_.push_back({f.name, 0});
  }

  /// Call after each step: the measured forces are those of the world's last evaluation.
  void observe(World& world) {
    const std::vector<Point> now = positions(world);
    std::vector<VertexForces> forces = measureForces(world, slotIn(world));
    for (std::size_t f = 0; f < forces.size(); ++f)
      for (std::size_t v = 0; v < now.size(); ++v)
        works_[f].work += 0.5 * dot(forces_[f].onVertex[v] + forces[f].onVertex[v], now[v] - before_[v]);
    before_ = now;
    forces_ = std::move(forces);
  }

  /// Returns the works, largest first, of forces that the scene has.
  std::vector<ForceWork> works() const {
    std::vector<ForceWork> sorted = works_;
    std::ranges::stable_sort(sorted, std::ranges::greater(), &ForceWork::work);
    return sorted;
  }

 private:
  int slotIn(const World& world) const { return world.bodies->slots[cellNumber(world.cells, cell_)]; }

  std::vector<Point> positions(const World& world) const {
    const int slot = slotIn(world);
    std::vector<Point> points;
    for (int v = 0; v < world.bodies->vertexCount(slot); ++v) points.push_back(world.bodies->vertex(slot, v));
    return points;
  }

  CellPath cell_;
  std::vector<Point> before_;
  std::vector<VertexForces> forces_;
  std::vector<ForceWork> works_;
};

// The work of forces is measured in all steps from the last good state on, or in the last few steps if these would be
// more than maxStepsMeasured.
constexpr std::uint64_t maxStepsMeasured = 512;
constexpr std::uint64_t fewStepsMeasured = 16;
constexpr std::uint64_t statesKept = 32;  // max states of a run that are checked for the last good one

/// [1] The range of a good cell's volume over its volume at rest.
constexpr double goodLeast = 0.5, goodMost = 2;

/// Counts the cost of a diagnosis [vertices times evaluations of the forces].
class Budget {
 public:
  bool allows(const World& world, std::uint64_t steps) const {
    return spent_ + costOf(world) * static_cast<double>(steps) <= diagnosisLimit;
  }
  void spend(const World& world, std::uint64_t steps) { spent_ += costOf(world) * static_cast<double>(steps); }

 private:
  static double costOf(const World& world) {
    return static_cast<double>(world.bodies->livingVertices) *
           static_cast<double>(1 + world.stages.furtherDrifts.size());
  }
  double spent_ = 0;
};

bool cellsAreWithin(const World& world, double least, double most) {
  const Bodies& b = *world.bodies;
  return std::all_of(b.slots.begin(), b.slots.end(), [&](int slot) {
    const double share = b.volume[slot] / measureRestVolume(b, slot);
    return share >= least && share <= most;
  });
}

/// A stored state of the run that failed.
struct Kept {
  std::uint64_t step = 0;
  double time = 0;
  std::string state;
};

/// The run again, up to the step before its failure.
struct Rerun {
  Kept start, good, last;  // `good`: the latest stored state with good cells;
                           // `last`: a few steps before the failure
};

Kept keep(const World& world) { return {world.clock.step, world.clock.time, saveState(world)}; }

std::optional<Rerun> runAgain(const Scene& scene, const Execution& execution, std::uint64_t failedStep,
                              Budget& budget) {
  World world = makeWorld(scene, execution);
  Rerun rerun{keep(world), {}, {}};
  rerun.good = rerun.last = rerun.start;
  const std::uint64_t end = failedStep > 0 ? failedStep - 1 : 0, apart = std::max<std::uint64_t>(1, end / statesKept);
  const std::uint64_t lookFrom = end > fewStepsMeasured ? end - fewStepsMeasured : 0;
  while (world.clock.step < end) {
    const std::uint64_t now = world.clock.step;
    std::uint64_t steps = std::min(end - now, apart - now % apart);
    if (now < lookFrom) steps = std::min(steps, lookFrom - now);
    if (!budget.allows(world, steps)) return {};
    budget.spend(world, steps);
    takeSteps(world, steps);
    if (world.clock.step % apart == 0 && cellsAreWithin(world, goodLeast, goodMost)) rerun.good = keep(world);
    if (world.clock.step == lookFrom) rerun.last = keep(world);
  }
  return rerun;
}

World restored(const Scene& scene, const Execution& execution, const std::string& state) {
  World world = makeWorld(scene, execution);
  restoreState(world, state);
  return world;
}

std::string share(double part, double whole) { return std::to_string(std::lround(100 * part / whole)) + " %"; }

/// Returns "in the 16 steps before contacts did 91 % of the work that drove it, springs 9 %".
std::string describeWork(const std::vector<ForceWork>& works, std::uint64_t steps) {
  double all = 0;
  for (const ForceWork& w : works)
    if (w.work > 0) all += w.work;
  const std::string when = steps == 1 ? "in the step before " : "in the " + std::to_string(steps) + " steps before ";
  if (!(all > 0) || !(all < INFINITY)) return when + "no force drove the cell, only its own motion";
  std::string text = when + works[0].force + " did " + share(works[0].work, all) + " of the work that drove the cell";
  for (std::size_t i = 1; i < works.size(); ++i)
    if (works[i].work > 0.01 * all) text += ", " + works[i].force + " " + share(works[i].work, all);
  return text;
}

/// Describes the work of forces on the cell before its end; "" if the cell has just been born.
std::string measureWork(World& world, const CellPath& cell, std::uint64_t failedStep) {
  std::optional<WorkMeter> meter;
  std::uint64_t steps = 0;
  while (world.clock.step + 1 < failedStep) {
    if (!meter && cellNumber(world.cells, cell) >= 0) meter.emplace(world, cell);
    step(world);
    if (meter) meter->observe(world), ++steps;
  }
  return meter && steps > 0 ? describeWork(meter->works(), steps) : "";
}

/// Returns "the time step 0.01 is 0.4 of the lowest stability limit, that of its springs".
std::string describeLimit(const World& world, const CellPath& cell) {
  const int number = cellNumber(world.cells, cell);
  if (number < 0) return "";
  const Bodies& b = *world.bodies;
  const int slot = b.slots[number];
  const PhysicsParameters& p = b.parameters;
  struct Limit {
    const char* of;
    double time;
  };
  const StabilityLimits own = measureLimits(b, slot);
  std::vector<Limit> limits{{b.model().hasMembrane ? "its springs" : "its shape", own.spring},
                            {"its pressure", own.pressure},
                            {"its bending", own.bending},
                            {"drag", dragLimit(p.integrator, p.drag)}};
  if (world.contacts && world.contacts->parameters.law != ContactLaw::thesis)
    limits.push_back({"contacts", contactLimit(p.integrator, world.contacts->parameters.stiffness,
                                               world.contacts->damping, b.vertexMass[slot], p.drag)});
  const Limit lowest =
      *std::min_element(limits.begin(), limits.end(), [](const Limit& x, const Limit& y) { return x.time < y.time; });
  if (!(lowest.time > 0 && lowest.time < INFINITY)) return "";
  return "the time step " + exactText(world.clock.timeStep) + " is " +
         numberText(world.clock.timeStep / lowest.time, 2) + " of the lowest stability limit, that of " + lowest.of;
}

enum class Outcome { holds, fails, refused, tooLong };

/// Tries if the run with the change goes on past the failure: as long again as from the state to the failure.
Outcome tryChange(const Remedy& remedy, World world, double failedTime, Budget& budget) {
  const double until = failedTime + (failedTime - world.clock.time);
  try {
    remedy.apply(world);
    chooseTimeStep(world);
    evaluateForces(world);
    checkBodies(world);
  } catch (const NumericalError&) { return Outcome::refused; }
  try {
    while (world.clock.time < until && !finished(world)) {
      const std::uint64_t steps = std::min<std::uint64_t>(64, stepsUntil(world.clock, until));
      if (!budget.allows(world, steps)) return Outcome::tooLong;
      budget.spend(world, steps);
      takeSteps(world, steps);
    }
  } catch (const NumericalError&) { return Outcome::fails; }
  return cellsAreWithin(world, sanity::minVolume, sanity::maxVolume) ? Outcome::holds : Outcome::fails;
}

/// Returns "physics.time_step 0.001 or 0.0005", with the values of one key together.
std::string list(const std::vector<const Remedy*>& remedies) {
  std::string text;
  const std::string* key = nullptr;
  for (const Remedy* t : remedies) {
    if (key && *key == t->key) text += " or " + t->value;
    else text += (text.empty() ? "" : ", ") + t->key + " " + t->value;
    key = &t->key;
  }
  return text;
}

struct FailureFindings {
  std::vector<const Remedy*> failed;
  const Remedy* helped = nullptr;
  bool cutShort = false;
};

FailureFindings tryAll(const std::vector<Remedy>& remedies, const Scene& scene, const Execution& execution,
                       const Kept& from, double failedTime, Budget& budget) {
  FailureFindings found;
  for (const Remedy& remedy : remedies) {
    switch (tryChange(remedy, restored(scene, execution, from.state), failedTime, budget)) {
      case Outcome::holds: found.helped = &remedy; return found;
      case Outcome::fails: found.failed.push_back(&remedy); break;
      case Outcome::refused: break;
      case Outcome::tooLong: found.cutShort = true; return found;
    }
  }
  return found;
}

std::string describe(const FailureFindings& found, const Kept& from, const BodyFailure& failure) {
  const std::string since = from.step == 0
                                ? "tried from the start: "
                                : "tried from step " + std::to_string(from.step) + " on, when all was well: ";
  std::string text;
  if (!found.failed.empty())
    text = since + list(found.failed) + (found.failed.size() == 1 ? " does" : " do") + " not help";
  if (found.helped) {
    text += (text.empty() ? since : "; ") + found.helped->key + " " + found.helped->value + " helps";
    return text + (failure.timeStep > 0 ? "; " + failure.remedy : ": use it");
  }
  if (found.cutShort)
    return text + (text.empty() ? "" : "; ") +
           "no more remedies were tried, because the diagnosis reached its "
           "limit; " +
           failure.remedy;
  return text + (text.empty() ? "no remedy could be tried; " : "; ") + failure.remedy;
}

void append(std::string& text, const std::string& more) {
  if (!more.empty()) text += (text.empty() ? "" : "; ") + more;
}

}  // namespace

std::string diagnose(const Scene& scene, const Execution& execution, const BodyFailure& failure) {
  Budget budget;
  const auto rerun = runAgain(scene, execution, failure.step, budget);
  std::string remedy;
  if (!rerun) {
    remedy = "no remedy was tried, because the run is too long to be repeated; " + failure.remedy;
  } else {
    const bool isNear = failure.step - rerun->good.step <= maxStepsMeasured;
    World last = restored(scene, execution, (isNear ? rerun->good : rerun->last).state);
    const CellPath cell = CellPath::parse(failure.cell);
    const std::string limit = describeLimit(last, cell);
    append(remedy, measureWork(last, cell, failure.step));
    append(remedy, limit.empty() ? describeLimit(last, cell) : limit);
    const double failedTime = timeAfter(last.clock, 1);
    const std::vector<Remedy> remedies = remediesFor(last, failure.timeStep);
    FailureFindings found = tryAll(remedies, scene, execution, rerun->good, failedTime, budget);
    const Kept* from = &rerun->good;
    if (!found.helped && !found.cutShort && rerun->good.step > 0) {
      found = tryAll(remedies, scene, execution, rerun->start, failedTime, budget);
      from = &rerun->start;
    }
    append(remedy, describe(found, *from, failure));
  }
  return NumericalError(failure.cell, failure.step, failure.quantity, remedy).what();
}

}  // namespace morula
