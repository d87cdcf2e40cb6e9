// Measuring changes nothing, and counters are equal everywhere.
#include "bench/subject.h"

#include "base/random.h"
#include "bench/machine_limits.h"
#include "bench/peak_kernels.h"
#include "catch.h"
#include "observation/measures.h"
#include "state/state_hash.h"
#include "system/clock.h"
#include "worst.h"

using namespace morula;

namespace {

Subject someSubject(bool contact = true) {
  return Subject({.cells = 9, .level = 1, .contact = contact}, 2, "", [](const std::string&) {});
}

}  // namespace

TEST_CASE("Timing a stage leaves the state as it was") {
  for (const bool contact : {true, false}) {
    Subject subject = someSubject(contact);
    const Hash before = stateHash(subject.world());
    const auto accelerations = subject.world().bodies->acceleration;
    for (const Isa isa : availableIsas()) {
      CHECK(subject.timeInternal(isa) > 0);
      CHECK(subject.timeIntegration(isa) > 0);
      CHECK(subject.trySteps(isa, 1, ClockKind::cpu, 10) > 0);
      if (contact) CHECK(subject.timeContact(isa) > 0);
    }
    CHECK(subject.trySteps(bestIsa(), 2, ClockKind::wall, 10) > 0);
    if (contact)
      for (const ContactSearch method : valuesOf<ContactSearch>()) {
        CHECK(subject.timeRebuild(bestIsa(), method) > 0);
        CHECK(subject.timeChoice(bestIsa()) > 0);
        Contacts contacts = subject.contactsToSearch(bestIsa(), method);
        refreshList(contacts, *subject.world().bodies, 1);
        CHECK(contacts.list.pairs > 0);
        CHECK(contacts.list.pairs < 20 * subject.vertices());  // only near pairs, at the surfaces' positions
        CHECK(contacts.listsThinned == subject.lists());       // a choice for all follows the search
        CHECK(countSlots(contacts) < contacts.list.pairs);
      }
    CHECK(stateHash(subject.world()) == before);
    CHECK(subject.world().bodies->acceleration == accelerations);
    CHECK(subject.counters().steps == 0);
  }
}

TEST_CASE("Counters are the same on every instruction set, whatever was timed in between") {
  StepCounters first;
  Hash state;
  for (const Isa isa : availableIsas()) {
    CAPTURE(name(isa));
    Subject subject = someSubject();
    subject.goOn(isa, 4000);
    if (isa != Isa::scalar) {
      subject.timeContact(Isa::scalar);
      subject.trySteps(Isa::scalar, 1, ClockKind::cpu, 7);
    }
    subject.goOn(isa, 4000);
    const StepCounters c = subject.counters();
    CHECK(c.steps == 8000);
    CHECK(c.rebuilds > 0);
    CHECK(c.pairs > 8000 * subject.vertices());
    CHECK(c.looks == 8000 / stirEvery);
    CHECK(c.slots < c.pairs / 8000 * c.looks);
    CHECK(c.listsThinned > c.rebuilds * subject.lists());
    if (isa == Isa::scalar) {
      first = c;
      state = stateHash(subject.world());
      continue;
    }
    CHECK(c.rebuilds == first.rebuilds);
    CHECK(c.pairs == first.pairs);
    CHECK(c.listsThinned == first.listsThinned);
    CHECK(c.slots == first.slots);
    CHECK(stateHash(subject.world()) == state);
  }
}

TEST_CASE("Slots are all that the slices hold, looked at once per stirring and at the end") {
  Subject subject = someSubject();
  subject.goOn(bestIsa(), 10);
  std::size_t slots = 0;
  for (const BlockLists& block : subject.world().contacts->list.perBlock)
    slots += block.indices.size() - linesPrefetched * blockLanes;
  CHECK(subject.counters().slots == slots);
  CHECK(subject.counters().looks == 1);
  subject.goOn(bestIsa(), stirEvery + 1);
  CHECK(subject.counters().looks == 3);
}

TEST_CASE("Cells that lie still get no pushes, and stirred ones do") {
  const auto speed = [](bool stirred) {
    Subject subject({.cells = 9, .level = 1, .stirred = stirred}, 1, "", [](const std::string&) {});
    subject.goOn(bestIsa(), stirEvery);  // the last push has just come
    return measureWorld(subject.world()).at("kinetic_energy");
  };
  CHECK(speed(false) < 0.05 * speed(true));
}

TEST_CASE("Ordinary code computes the same forces as the kernels, to rounding") {
  PhysicsParameters p;
  p.drag = 3;
  Bodies bodies = makeBodies(p, makeIcosphere(2), 1);
  Body shaken = makeEgg(bodies);
  for (std::uint32_t v = 0; v < shaken.position.size(); ++v) {
    shaken.position[v] += 0.03 * randomDirection({1, {}, v, Purpose::test});
    shaken.velocity[v] = randomDirection({2, {}, v, Purpose::test});
  }
  shaken.restScale = 0.9;
  setBodies(bodies, {shaken});
  const PhysicsStages stages = chooseStages(p, bestIsa());
  advance(stages, bodies, bodies.block(0, 0), 0);
  OrdinaryCell cell = makeOrdinaryCell(bodies.mesh, shaken);
  findForces(cell, p);
  CHECK(cell.volume == Approx(bodies.volume[0]).epsilon(1e-13));
  CHECK(cell.pressure == Approx(bodies.pressure[0]).epsilon(1e-12));
  Worst apart, size;
  for (int v = 0; v < bodies.vertexCount(); ++v) {
    apart.see(norm(cell.vertices[v].force - bodies.read(bodies.acceleration, 0, v)));
    size.see(norm(cell.vertices[v].force));
  }
  CHECK(size > 0.1);
  CHECK(apart < 1e-13 * (1 + size));
}

TEST_CASE("The middle of measurements") {
  CHECK(median({3}) == 3);
  CHECK(median({9, 1, 2}) == 2);
  CHECK(median({1, 2, 3, 100}) == 2.5);
  CHECK(spread({7}) == 0);
  CHECK(spread({8, 9, 10, 11, 12}) == Approx(0.1));
}

TEST_CASE("What measures memory does what it says") {
  AlignedVector<double> a(24), b(24), c(24);
  for (int i = 0; i < 24; ++i) b[i] = i, c[i] = 0.5 * i;
  for (const Isa isa : availableIsas()) {
    a.assign(24, 0);
    peakKernels(isa).triad(a.data(), b.data(), c.data(), 24);
    for (int i = 0; i < 24; ++i) CHECK(a[i] == 2 * i);
    CHECK(peakKernels(isa).issue(3) == 3);
    // The chains tend to term / (1 − factor) = 1, twelve in each lane.
    const int lanes = peakKernels(isa).operationsPerTurn / 24;
    CHECK(peakKernels(isa).multiplyAdd(20'000'000 / lanes) == Approx(12 * lanes).epsilon(0.2));
  }
}

TEST_CASE("Each size of memory has its bandwidth, and what is larger than all that of the largest") {
  MachineLimits limits;
  limits.bandwidth = {{1000, 3e9}, {2000, 2e9}, {9000, 1e9}};
  CHECK(limits.bandwidthFor(0) == 3e9);
  CHECK(limits.bandwidthFor(1000) == 3e9);
  CHECK(limits.bandwidthFor(1001) == 2e9);
  CHECK(limits.bandwidthFor(1e6) == 1e9);
}
