// A trial of the harness: faults are put into runs, stored results and goldens, and each must be named with its class,
// step and cell. For runs, an oracle walks both side by side and finds the step at which they part.

#include "catch.h"
#include "contacts/contacts.h"
#include "explain/explain.h"
#include "simulation/population.h"
#include "unit/explain/runs.h"

using namespace morula;

namespace {

/// The step of the faults: four cells live, and others are still to be born. It is no multiple of any stride.
constexpr std::uint64_t when = 149;

/// Returns a scene with cells that are alive at `when`, which faults can change.
Scene lively() {
  Scene s = scenes::life();
  s.cycle.length = 0.375;
  return s;
}

struct RunFault {
  const char* what;
  FailureClass failureClass;
  std::optional<std::string> cell;
  const char* field;
  Change after, before = {};  // changes after or before step number `when`
  std::uint64_t step = when;  // at which the fault shows; 0: it happens before the first
  Scene scene = lively();
};

const std::optional<std::string> noCell;  // for faults of no single cell
const Change nothing;

void nudge(double& x) { x = std::nextafter(x, 1e300); }
void nudge(Reals::Reference x) { x = std::nextafter(double(x), 1e300); }

const CellChange noChange = CellChange::none;

void change(World& w, std::size_t cell, CellChange what) {
  std::vector<CellChange> changes(w.cells.path.size(), noChange);
  changes[cell] = what;
  changePopulation(w, Observation(w), changes);
}

/// Returns a cell's largest number along x in an array, whose change is not lost in rounding.
Reals::Reference largest(const Bodies& b, Reals& array, int cell) {
  const int slot = b.slots[cell];
  std::size_t at = b.at(slot, 0);
  for (int v = 0; v < b.vertexCount(slot); ++v)
    if (std::abs(array[b.at(slot, v)]) > std::abs(array[at])) at = b.at(slot, v);
  return array[at];
}

/// Removes all of a cell's contacts from the list.
void dropContacts(World& w, int cell) {
  w.contacts->list.skin = w.contacts->acting.horizon = w.contacts->acting.margin = 1e9;  // prevents a new list
  const auto far = static_cast<std::int32_t>(w.contacts->list.reference.size() / 3);
  const int slot = w.bodies->slots[cell], lane = slot % blockLanes;
  BlockLists& lists = w.contacts->list.perBlock[slot / blockLanes];
  for (const NeighbourSlice& slice : lists.slices)
    for (int l = 0; l < blockLanes; ++l)
      for (int k = 0; slice.vertex[l] % blockLanes == lane && k < slice.length; ++k)
        lists.indices[(slice.start + k) * blockLanes + l] = far;
}

OwnRun faultyRun(const RunFault& fault) {
  const auto advance = [&fault](World& w) {
    const bool now = w.clock.step + 1 == when;
    if (now && fault.before) fault.before(w);
    step(w);
    if (now && fault.after) fault.after(w);
  };
  return {"actual",
          [&fault] {
            World w = makeWorld(fault.scene, {Isa::scalar, 1});
            if (fault.step == 0) fault.after(w);
            return w;
          },
          advance};
}

/// Returns the first step at which the runs differ: walks both side by side, one step at a time.
std::uint64_t firstStepThatDiffers(const RunFault& fault) {
  OwnRun clean = runOf(fault.scene, ""), faulty = faultyRun(fault);
  for (std::uint64_t s = 0;; ++s) {
    const HashTrace e = clean.hashTrace(s, s, 1), a = faulty.hashTrace(s, s, 1);
    if (!a.failure.empty() || e.links.empty() || a.links.empty()) return s;
    if (e.links.back().state.whole != a.links.back().state.whole) return s;
  }
}

}  // namespace

TEST_CASE("Faults in a run: class, step, cell and field of each are named") {
  const Scene life = lively();
  Scene crowd = scenes::packed();
  crowd.cycle.length = life.cycle.length;
  World there = makeWorld(life, {Isa::scalar, 1});
  while (there.clock.step < when) step(there);
  REQUIRE(there.cells.path.size() >= 3);
  const auto cell = [&](std::size_t i) { return there.cells.path[i].text(); };
  const std::string last = there.cells.path.back().text();
  std::uint64_t division = 0;  // step at which daughters appear, after the fault's step
  for (World w = makeWorld(life, {Isa::scalar, 1}); division == 0; step(w))
    for (const LineageEntry& e : w.lineage.entries)
      if (e.bornStep > when && division == 0) division = e.bornStep;

  const std::vector<RunFault> faults{
      {"a position, one ulp", FailureClass::computation, cell(1), "position",
       [](World& w) { nudge(w.bodies->position[w.bodies->at(w.bodies->slots[1], 5)]); }},
      {"the last coordinate of the last cell", FailureClass::computation, last, "position",
       [](World& w) {
         Bodies& b = *w.bodies;
         const int slot = b.slots.back();
         nudge(b.position[b.at(slot, b.vertexCount(slot) - 1) + 2 * blockLanes]);
       }},
      {"a velocity, one ulp", FailureClass::computation, cell(0), "velocity",
       [](World& w) { nudge(largest(*w.bodies, w.bodies->velocity, 0)); }},
      {"an acceleration, one ulp", FailureClass::computation, cell(2), "acceleration",
       [](World& w) { nudge(largest(*w.bodies, w.bodies->acceleration, 2)); }},
      {"a velocity that is no number", FailureClass::computation, cell(1), "velocity",
       [](World& w) { w.bodies->velocity[w.bodies->at(w.bodies->slots[1], 3)] = std::nan(""); }},
      {"an infinite position", FailureClass::computation, cell(1), "position",
       [](World& w) { w.bodies->position[w.bodies->at(w.bodies->slots[1], 3)] = INFINITY; }},
      {"a mass", FailureClass::computation, cell(1), "vertex mass",
       [](World& w) { nudge(w.bodies->vertexMass[w.bodies->slots[1]]); }},
      {"a rest length", FailureClass::computation, cell(2), "rest scale",
       [](World& w) { nudge(w.bodies->restScale[w.bodies->slots[2]]); }},
      {"the gas", FailureClass::computation, cell(0), "pressure constant",
       [](World& w) { nudge(w.bodies->pressureConstant[w.bodies->slots[0]]); }},
      {"two cells change places", FailureClass::computation, cell(1), "position",
       [](World& w) {
         Bodies& b = *w.bodies;
         for (int v = 0; v < b.vertexCount(b.slots[1]); ++v) {
           const Point x = b.vertex(b.slots[1], v);
           b.write(b.position, b.slots[1], v, b.vertex(b.slots[2], v));
           b.write(b.position, b.slots[2], v, x);
         }
       }},
      {.what = "the contacts of one cell are dropped",
       .failureClass = FailureClass::computation,
       .cell = "AB",
       .field = "acceleration",
       .after = [](World& w) { setInfluenceRadii(*w.contacts, *w.bodies); },
       .before = [](World& w) { dropContacts(w, 1); },
       .scene = crowd},
      {"a spring constant", FailureClass::computation, cell(0), "acceleration", nothing,
       [](World& w) { w.bodies->kernelParameters.stiffness *= 1 + 1e-15; }},
      {"the time step, one ulp", FailureClass::computation, noCell, "clock.time step",
       [](World& w) { nudge(w.clock.timeStep); }},
      {"a connection that never was", FailureClass::computation, noCell, "connections ever",
       [](World& w) { w.connections->history.pop_back(); }},
      {"a connection made at another time", FailureClass::computation, "A", "connection made",
       [](World& w) { nudge(w.connections->history[0].made); }},
      {"swapped daughters", FailureClass::lineage, cell(0), "substances",
       [](World& w) { std::swap(w.cells.state[0], w.cells.state[1]); }},
      {"a cell dies", FailureClass::lineage, cell(1), "life", [](World& w) { change(w, 1, CellChange::dies); }},
      {"a cell divides", FailureClass::lineage, cell(0), "life", [](World& w) { change(w, 0, CellChange::divides); }},
      {"a cell grows that should not", FailureClass::lineage, cell(2), "growth",
       [](World& w) { w.cells.growth[2] = 1; }},
      {"a cell cycle counted late", FailureClass::lineage, cell(1), "last cell cycle",
       [](World& w) { w.cells.lastCycle[1] += 0.01; }},
      {"a birth recorded elsewhere", FailureClass::lineage, "B", "born at step",
       [](World& w) { ++w.lineage.entries[2].bornStep; }},
      {"all cell cycles one step late", FailureClass::lineage, cell(0), "life", nothing,
       [](World& w) { w.clock.nextCycle += 1.5 * w.clock.timeStep; }, division},
      {"the egg, one ulp", FailureClass::setup, "", "position",
       [](World& w) { nudge(w.bodies->position[w.bodies->at(0, 7) + blockLanes]); }, nothing, 0},
      {"a zero with another sign", FailureClass::setup, "", "velocity",
       [](World& w) { w.bodies->velocity[w.bodies->at(0, 2)] = -double(w.bodies->velocity[w.bodies->at(0, 2)]); },
       nothing, 0},
      {"an egg of another substance", FailureClass::setup, "", "substances",
       [](World& w) { w.cells.state[0] = w.biology->daughterState(w.cells.state[0], true); }, nothing, 0},
  };
  REQUIRE(faults.size() >= 25);
  for (const RunFault& fault : faults) {
    CAPTURE(fault.what);
    const std::uint64_t parting = firstStepThatDiffers(fault);
    OwnRun expected = runOf(fault.scene, "expected"), actual = faultyRun(fault);
    Explanation x = explain(expected, actual, 64);
    if (x.failureClass == FailureClass::none)
      x = explain(expected, actual, 1);  // the difference has healed, but shows step by step
    CAPTURE(x.text);
    CHECK(x.failureClass == fault.failureClass);
    REQUIRE(x.step);
    CHECK(*x.step == parting);
    CHECK(*x.step == fault.step);
    CHECK(x.cell == fault.cell);
    REQUIRE(x.difference);
    CHECK(x.difference->field == fault.field);
    CHECK(x.difference->expected != x.difference->actual);
    if (*x.step > 0) CHECK(x.lastEqual == *x.step - 1);
  }
}

TEST_CASE("Two equal runs have nothing to explain, however they are computed") {
  const Scene scene = lively();
  OwnRun first = runOf(scene, "first"), second = runOf(scene, "second", step, {bestIsa(), 3});
  const Explanation x = explain(first, second, 64);
  CHECK(x.failureClass == FailureClass::none);
  CHECK_FALSE(x.step);
  CHECK_THAT(x.text, ContainsSubstring("the same bits"));
}

TEST_CASE("Two runs of one program that differ are nondeterminism, wherever it begins") {
  const Scene scene = lively();
  OwnRun first = runOf(scene, "first"),
         second =
             runOf(scene, "second", changingAt(when, [](World&w) { nudge(w.bodies->velocity[w.bodies->at(0, 7)]); }));
  const Explanation x = explainTwice(first, second);
  CHECK(x.failureClass == FailureClass::nondeterminism);
  CHECK(x.step == when);
  CHECK(x.difference->vertex == 7);
  CHECK(x.difference->component == "x");
  CHECK_THAT(x.text, ContainsSubstring("1 ulp apart"));
}

TEST_CASE("A difference that heals between two states looked at is seen step by step only") {
  const Scene scene = lively();
  const auto healing = [&] {
    return runOf(scene, "healing", [before = Reals()](World& w) mutable {
      if (w.clock.step == when) w.bodies->velocity = before;
      step(w);
      if (w.clock.step == when) before = w.bodies->velocity, w.bodies->velocity[0] += 1;
    });
  };
  OwnRun clean = runOf(scene, "clean"), coarse = healing(), fine = healing();
  CHECK(explain(clean, coarse, 64).failureClass == FailureClass::none);
  CHECK(explain(clean, fine, 1).step == when);
}

TEST_CASE("A difference in the last steps, beyond the last stride, is found") {
  Scene scene = lively();
  scene.stop.time = 2.03;
  const std::uint64_t end = ranToEnd(scene).clock.step;
  REQUIRE(end % 64 != 0);
  OwnRun first = runOf(scene, "first"),
         second = runOf(scene, "second", changingAt(end, [](World&w) { nudge(w.bodies->position[0]); }));
  CHECK(explain(first, second).step == end);
}

TEST_CASE("A run that ends too early is told") {
  Scene scene = lively(), shorter = scene;
  shorter.stop.time = 1;
  OwnRun first = runOf(scene, "first"), second = runOf(shorter, "second");
  const Explanation x = explain(first, second);
  CHECK(x.failureClass == FailureClass::computation);
  CHECK(*x.lastEqual == ranToEnd(shorter).clock.step);
  CHECK(*x.step == *x.lastEqual + 1);
}
