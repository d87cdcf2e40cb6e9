// The stability limit falls with each division: springs and pressure stay as strong while masses halve.
#include "simulation/time_step.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "base/error.h"
#include "base/maths.h"
#include "base/number_text.h"
#include "base/random.h"
#include "contacts/contacts.h"
#include "observation/body_measures.h"
#include "observation/sanity.h"
#include "physics/integrator.h"
#include "physics/stability.h"
#include "simulation/body_failure.h"
#include "simulation/cycle_lengths.h"
#include "simulation/move_physics.h"

namespace morula {
namespace {

constexpr double margin = 0.8;     // share of a stability limit
constexpr double maxSteps = 1e12;  // more than a week of one small cell

struct Limit {
  double spring, pressure, contact;  // [time]; contact is infinite without pair contact
  double connection;                 // [time] infinite without springs between cells
  double bending;                    // [time] infinite without bending
  int cell;
};

/// Combines the limits of all modes: stiffnesses add up, and a limit goes with 1/√stiffness, explicit Euler's with
/// 1/stiffness.
double combine(Integrator integrator, const Limit& l) {
  if (kindOf(integrator).needsDrag)
    return 1 / (1 / l.spring + 1 / l.pressure + 1 / l.contact + 1 / l.connection + 1 / l.bending);
  const double least = std::min({l.spring, l.pressure, l.contact, l.connection, l.bending});
  if (!(least < INFINITY)) return INFINITY;
  const double a = least / l.spring, b = least / l.pressure, c = least / l.contact, d = least / l.connection,
               e = least / l.bending;  // no square is too small
  return least / std::sqrt(a * a + b * b + c * c + d * d + e * e);
}

/// Returns the stiffness [force/length] of all springs to a cell, with the partners' motion. Counts the springs of the
/// cell with most, and those that contacts may add before the next choice of a time step.
double connectionStiffness(const World& world) {
  if (!world.connections || !world.connections->parameters.spring) return 0;
  const Connections& c = *world.connections;
  const std::uint64_t usual = 20;  // neighbours of a cell in a heap, with some margin
  std::uint64_t most = c.parameters.most ? std::min(*c.parameters.most, usual) : usual;
  std::map<CellPath, std::uint64_t> count;
  for (std::size_t i : c.active)
    for (const CellPath& cell : {c.history[i].a, c.history[i].b}) most = std::max(most, ++count[cell]);
  return 2 * static_cast<double>(most) * c.parameters.spring->stiffness;
}

/// Returns the limit [time] of a whole cell that springs hold.
double connectionLimit(const World& world, double stiffness, int slot) {
  const PhysicsParameters& p = world.bodies->parameters;
  if (stiffness == 0) return INFINITY;
  const double m = world.bodies->mass(slot);
  const IntegratorKind& kind = kindOf(p.integrator);
  if (kind.needsDrag && p.drag == 0) return 0;
  return kind.oscillatorLimit(stiffness, kind.needsDrag ? p.drag * m : 0, m);
}

// [1] Membranes that stick fold, and where one-rings fold normals turn fast. Three and four cells of 42 vertices that
// collide without any damping and stick with W = 1 change their energy by up to 0.24 % at the step from this factor,
// and by 0.8 % at twice it. Thirteen that stay together (hard/perpetual) drift by 0.5 % in 100,000 steps of twice it.
constexpr double foldedAdhesion = 350;

// [1] The factor for cells that settle, whose energy need not be kept: damped motion gives more inertia to the few cells
// that meet more stiffness (damped_motion.cpp). With 350 sticking cells would need nine times the evaluations of others
// to come as near to rest; from 15 down to 5 nothing changes in what 64 of them become.
constexpr double settledAdhesion = 15;

// [1] contactLimit counts ten pairs of a vertex; one pair that has hardened this much beside others is as stiff.
constexpr double heldByLimit = 24;

/// Returns the stiffness [force/length] of one pair. Spheres either push or draw each other: the steeper slope counts.
double contactStiffness(const Contacts& c, const Bodies& b, double hardening) {
  const double adhesion = adhesionStiffness(c, b);
  if (b.areSpheres()) return std::max(c.parameters.stiffness, adhesion);
  const double folded = kindOf(b.parameters.integrator).settles ? settledAdhesion : foldedAdhesion;
  return hardening * c.parameters.stiffness + folded * adhesion;
}

/// Returns the limits of the cell in a slot. `held`, `contact`: stiffnesses of all its connections, and of a pair.
/// `steepness`: stiffness of its steepest pair over K.
Limit limitOf(const World& world, int cell, int slot, double held, double contact, double steepness) {
  const Bodies& b = *world.bodies;
  const StabilityLimits own = measureLimits(b, slot);
  Limit l{own.spring, own.pressure, INFINITY, connectionLimit(world, held, slot), own.bending, cell};
  if (!world.contacts || world.contacts->parameters.law == ContactLaw::thesis) return l;
  const ContactParameters& c = world.contacts->parameters;
  const auto limit = [&](double stiffness, double pairs) {
    return contactLimit(b.parameters.integrator, stiffness, world.contacts->damping, b.vertexMass[slot],
                        b.parameters.drag, pairs);
  };
  l.contact = limit(contact, usualPairs);
  // A pair that is stiffer than all others together, ω² = 2 k/m: both of its vertices move. The vertices that its other
  // pairs press on stand still, so these pairs damp it by half.
  constexpr double others = 0.5 * usualPairs;
  if (steepness > 0) l.contact = std::min(l.contact, limit(2 * steepness * c.stiffness / others, others));
  return l;
}

/// Returns by how much [1] hardened contacts are stiffer than limits count with anyway.
double excess(double hardening) { return std::max(1.0, hardening / heldByLimit); }

/// Returns the limits of the cell with the smallest combined limit. `steepness`: room for what contacts measure.
Limit tightestLimit(const World& world, std::vector<double>& steepness, double& combined) {
  Limit tightest{INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0};
  combined = INFINITY;
  const Bodies& b = *world.bodies;
  const double held = connectionStiffness(world);
  // A time step that the scene gives is compared with contacts before they harden.
  const bool follows = world.contacts && !b.parameters.timeStep;
  const double hard = follows ? excess(measureHardening(*world.contacts)) : 1;
  const double contact = world.contacts ? contactStiffness(*world.contacts, b, hard) : 0;
  // XPBD's steps are chosen at births alone: they would stay as short as fresh cuts are steep.
  const bool looks = follows && !kindOf(b.parameters.integrator).solvesForces;
  if (looks) measureSteepness(*world.contacts, b, world.execution.threads, steepness);
  for (int cell = 0; cell < b.count; ++cell) {
    const Limit l = limitOf(world, cell, b.slots[cell], held, contact, looks ? steepness[b.slots[cell]] : 0);
    const double all = combine(b.parameters.integrator, l);
    if (all < combined) combined = all, tightest = l;
  }
  return tightest;
}

/// Throws for the value of a key. `wrong`: what follows the key in the message.
[[noreturn]] void refuse(const World& world, int cell, const char* key, const std::string& wrong,
                         const std::string& remedy) {
  NumericalError error(world.cells.path[cell].text(), world.clock.step, key + wrong, remedy);
  error.key = key;
  throw error;
}

void refuseAbove(double limit, const char* mode, const World& world, int cell, double timeStep) {
  if (timeStep <= margin * limit) return;
  refuse(world, cell, "physics.time_step",
         " " + exactText(timeStep) + " is above 0.8 of the stability limit " + numberText(limit) + " of its " + mode,
         "use physics.time_step: auto, or at most " + exactText(powerOfTwoBelow(margin * limit)));
}

/// Throws for explicit Euler without drag.
[[noreturn]] void refuseUndamped(const World& world, int cell) {
  refuse(world, cell, "physics.integrator",
         " explicit-euler is stable with no time step where nothing damps the motion",
         "give the scene a physics.drag > 0, or use another physics.integrator");
}

/// Throws for XPBD without pair contact, and for spheres that nothing touches and nothing drags.
[[noreturn]] void refuseUnbounded(const World& world) {
  refuse(world, 0, "physics.time_step", ": auto follows stability limits, and this scene has none",
         "give physics.time_step a number");
}

/// Throws if masses and stiffnesses are such that no run comes to its end.
void refuseEndless(const World& world, int cell, double timeStep) {
  const auto end = plannedEnd(world.model);
  if (!end || *end - world.clock.time <= maxSteps * timeStep) return;
  refuse(world, cell, "physics.time_step",
         " is " + numberText(timeStep) + " and the run ends at time " + numberText(*end) + ": more than " +
             numberText(maxSteps) + " steps",
         "give cells more mass (physics.cell.mass, cells: scale), lower a stiffness "
         "(physics.membrane.stiffness, physics.pressure.constant, physics.contact.stiffness) or "
         "stop earlier");
}

/// Throws for a step that would hold two cycles of one cell.
void refuseAboveCycle(const World& world, double timeStep) {
  const ShortestCycle cycle = shortestCycle(world.model);
  if (timeStep <= cycle.length) return;
  refuse(world, 0, "physics.time_step",
         " " + exactText(timeStep) + " is longer than the shortest cell cycle, " + cycle.key +
             (world.model.variation.cycle > 0 ? " less variation.cycle: " : " ") + exactText(cycle.length),
         "use physics.time_step: auto, or at most " + exactText(powerOfTwoBelow(cycle.length)) + ", or give a longer " +
             cycle.key);
}

/// Throws as refuseAboveCycle does, for events that share a settling.
void refuseTogether(const World& world) {
  const double together = world.bodies->parameters.quasiStatic.together;
  const ShortestCycle cycle = shortestCycle(world.model);
  if (together < cycle.length) return;
  refuse(world, 0, "physics.quasi-static.together",
         " " + exactText(together) + " is not shorter than the shortest cell cycle, " + cycle.key +
             (world.model.variation.cycle > 0 ? " less variation.cycle: " : " ") + exactText(cycle.length),
         "give less, or 0: each round of events then settles by itself");
}

/// Throws for a step with which the run would end behind its stop.
void refuseAboveRun(const World& world, double timeStep) {
  const auto end = plannedEnd(world.model);
  if (!end || timeStep <= *end) return;
  refuse(world, 0, "physics.time_step",
         " " + exactText(timeStep) + " is longer than the whole run, which stops at " + exactText(*end),
         "use physics.time_step: auto, or at most " + exactText(powerOfTwoBelow(*end)) +
             ", or give a later stop.time or more stop.cycles");
}

struct Flight {
  double limit = INFINITY;  // [time] in which the cell moves by maxFlight
  int cell = 0;
};

/// Returns the flight of the cell that moves fastest relative to its reach, if there is another cell that it may meet.
Flight shortestFlight(const World& world) {
  Flight shortest;
  const Bodies& b = *world.bodies;
  if (!world.contacts || b.count < 2 || world.contacts->parameters.law == ContactLaw::thesis) return shortest;
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    const double limit = maxFlight * world.contacts->radius[slot] / norm(measureMeanVelocity(b, slot));
    if (limit < shortest.limit) shortest = {limit, cell};
  }
  return shortest;
}

void refuseFlight(const World& world, double timeStep) {
  const Flight flight = shortestFlight(world);
  if (timeStep <= flight.limit) return;
  throw NumericalError(world.cells.path[flight.cell].text(), world.clock.step,
                       "a cell moves by " + numberText(maxFlight * timeStep / flight.limit) +
                           " of its contacts' reach in a time step of " + exactText(timeStep) +
                           ": cells could pass through each other unseen",
                       "use physics.time_step: auto, or at most " + exactText(powerOfTwoBelow(flight.limit)) +
                           ", or lower what drives it: speeds (cells: velocity)");
}

/// Returns the smallest limit [time] that cells have while no contact is hard or steep.
double restingLimit(const World& world) {
  const Bodies& b = *world.bodies;
  const double held = connectionStiffness(world), contact = contactStiffness(*world.contacts, b, 1);
  double smallest = INFINITY;
  for (int cell = 0; cell < b.count; ++cell)
    smallest =
        std::min(smallest, combine(b.parameters.integrator, limitOf(world, cell, b.slots[cell], held, contact, 0)));
  return smallest;
}

/// Returns the longest automatic step. Drag is a mode of its own, which adds nothing to the stiffness of others.
double longest(double combined, const PhysicsParameters& p) {
  return margin * std::min(combined, dragLimit(p.integrator, p.drag));
}

/// Returns the longest automatic time step [time]: stable, and short enough for the fastest cell. Speed shortens steps
/// by 64 times at most: faster cells move farther than contacts reach in a step, and the run ends (checkReach).
double automaticLimit(const World& world, double combined) {
  constexpr double minShare = 1.0 / 64;
  const PhysicsParameters& p = world.bodies->parameters;
  const double stable = p.autoShare * longest(combined, p), flight = shortestFlight(world).limit;
  return flight < stable && flight > minShare * stable ? flight : stable;
}

}  // namespace

void followInertia(World& world, std::span<double> counted, std::span<const double> factor, bool anew) {
  Bodies& b = *world.bodies;
  const double held = connectionStiffness(world);
  if (world.contacts && anew) measureSteepness(*world.contacts, b, world.execution.threads, world.contacts->steepness);
  for (int block = 0; block < b.blockCount(); ++block) {
    const double hard = world.contacts ? excess(hardeningAt(world.contacts->deepest[block])) : 1;
    if (!anew && !(hard > counted[block])) continue;
    counted[block] = hard;
    const double contact = world.contacts ? contactStiffness(*world.contacts, b, hard) : 0;
    for (int slot = block * blockLanes; slot < block * blockLanes + b.liveLanes(block); ++slot) {
      const double steepness = world.contacts ? world.contacts->steepness[slot] : 0;
      const double share = margin * combine(b.parameters.integrator, limitOf(world, 0, slot, held, contact, steepness));
      // A cell that nothing holds and nothing touches has no limit, and no force to be moved by.
      if (share < INFINITY) setVertexMass(b, slot, b.vertexMass[slot] * factor[slot] / (share * share));
    }
  }
}

double timeStepLimit(const World& world) {
  std::vector<double> steepness;
  double combined;
  tightestLimit(world, steepness, combined);
  return longest(combined, world.bodies->parameters);
}

double automaticTimeStep(const Scene& scene, double limit) {
  return powerOfTwoBelow(std::min(limit, shortestCycle(scene).length));
}

void checkCrossing(const World& world) {
  constexpr std::uint64_t between = 4;  // [step] Cells in flight need ten to cross, on meshes of 12 vertices six
  if (!world.bodies || !world.contacts || world.clock.step % between != 0) return;
  if (measureHardening(*world.contacts) <= heldByLimit) return;  // nothing is pressed hard
  // Cells in flight are so fast that an automatic step follows from their speed, or did until they met.
  if (shortestFlight(world).limit > 2 * restingLimit(world)) return;
  const auto overlap = measureCellOverlap(world);
  if (!overlap || overlap->holds()) return;
  throw BodyFailure(overlap->cell->text(), world.clock.step,
                    "it shares " + numberText(overlap->value) + " of its volume with cell " + overlap->other->text() +
                        ": they pass through each other",
                    "raise physics.contact.stiffness, take a finer physics.mesh, or lower what drives them into "
                    "each other: speeds (cells: velocity)");
}

void followContacts(World& world) {
  if (!world.bodies || !world.contacts || world.bodies->count == 0) return;
  const PhysicsParameters& p = world.bodies->parameters;
  if (p.timeStep || kindOf(p.integrator).solvesForces || kindOf(p.integrator).settles) return;
  // [step] A step need not grow at once, nor shrink where vertices come to rest at the ends of their reach.
  constexpr std::uint64_t between = 64;
  const Clock& clock = world.clock;
  const bool mayGrow = (clock.step - clock.epochStep) % between == 0;
  if (!mayGrow && measureHardening(*world.contacts) <= heldByLimit) return;
  double combined;
  tightestLimit(world, world.contacts->steepness, combined);
  const double timeStep = automaticTimeStep(world.model, automaticLimit(world, combined));
  if (timeStep < clock.timeStep || (mayGrow && timeStep > clock.timeStep)) chooseTimeStep(world);
}

void chooseTimeStep(World& world) {
  if (world.bodies->count == 0) return;
  const PhysicsParameters& p = world.bodies->parameters;
  if (kindOf(p.integrator).settles) {
    refuseTogether(world);
    return evaluateForces(world);
  }
  double combined;
  std::vector<double> none;
  const Limit limit = tightestLimit(world, world.contacts ? world.contacts->steepness : none, combined);
  if (kindOf(p.integrator).needsDrag && !(combined > 0)) refuseUndamped(world, limit.cell);
  double timeStep;
  if (p.timeStep) {
    timeStep = *p.timeStep;
    refuseAboveCycle(world, timeStep);
    refuseAboveRun(world, timeStep);
    refuseAbove(limit.spring, kindOf(p.cell.model).limitedBy, world, limit.cell, timeStep);
    refuseAbove(limit.pressure, "pressure", world, limit.cell, timeStep);
    refuseAbove(limit.bending, "bending", world, limit.cell, timeStep);
    refuseAbove(limit.contact, "contacts", world, limit.cell, timeStep);
    refuseAbove(limit.connection, "connections' springs", world, limit.cell, timeStep);
    refuseAbove(dragLimit(p.integrator, p.drag), "drag", world, limit.cell, timeStep);
    refuseFlight(world, timeStep);
  } else {
    if (kindOf(p.integrator).solvesForces ? std::isinf(limit.contact) : std::isinf(longest(combined, p)))
      refuseUnbounded(world);
    timeStep = automaticTimeStep(world.model, automaticLimit(world, combined));
  }
  refuseEndless(world, limit.cell, timeStep);
  Clock& clock = world.clock;
  if (timeStep == clock.timeStep && !world.timeSteps.empty()) return;
  clock.timeStep = timeStep;
  clock.epochTime = clock.time;
  clock.epochStep = clock.step;
  const bool again = !world.timeSteps.empty() && world.timeSteps.back().step == clock.step;  // births, then contacts
  if (again) world.timeSteps.pop_back();
  world.timeSteps.push_back({clock.time, clock.step, timeStep});
  evaluateForces(world);  // the thesis' contact law depends on the time step, and so does viscosity at long ones
}

}  // namespace morula
