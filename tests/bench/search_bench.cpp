// Prints a table of the cost of each way to find contacts, for packed cells. For comparison: the time per cell grows
// more than twelvefold from 128 to 256 cells in [Nilsson 2008, table 5.1].
//
//   bench_search [LARGEST] [ISA]     cells of the last row, 256 unless told; an organism of 1024 takes
//   minutes
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "biology/dna.h"
#include "biology/full_tree.h"
#include "contacts/contacts.h"
#include "simulation/move_physics.h"
#include "simulation/simulation.h"
#include "system/clock.h"

using namespace morula;

namespace {

constexpr double fixedStep = 1.0 / 2800;  // between the stability limits of 128 and of 256 of these cells

/// Returns the CPU time of one call [ns], averaged over `calls` and summed over threads: other programs disturb CPU
/// time least.
template <class Work>
double timed(int calls, const Work& work) {
  return 1e9 / calls * timeOf(ClockKind::process, [&] {
           for (int k = 0; k < calls; ++k) work();
         });
}

/// Returns the median of five timings.
template <class Work>
double timedOften(int calls, const Work& work) {
  std::vector<double> times(5);
  for (double& time : times) time = timed(calls, work);
  return median(times);
}

/// Returns a scene in which all cells divide `generations` times and fill the unit sphere.
Scene organism(int generations) {
  Scene scene;
  scene.name = "packed";
  scene.dna = parseDna(makeFullTreeDna(generations), "packed");
  scene.cycle.length = 0.5;
  scene.stop.cycles = generations + 1;
  MechanicsScene m;
  m.mesh = makeIcosphere(2);
  m.physics.drag = 20;
  m.physics.shell = ShellParameters{};
  m.contact = ContactParameters{};
  m.contact->viscosity = 0;
  scene.mechanics = m;
  return scene;
}

void printHead() {
  std::printf(
      "| cells | way to search | skin | search ns/v | ms per cell | pairs | distance tests | bins | roots | boxes |\n"
      "|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
}

/// Prints one row: searches of the present world. Figures are per vertex and search.
void printSearch(const World& world, ContactSearch method, double skinShare, Isa isa) {
  const Bodies& bodies = *world.bodies;
  const double vertices = double(bodies.count) * bodies.vertexCount();
  NeighbourList list = makeNeighbourList(method, isa);
  list.skin =
      skinShare * *std::min_element(world.contacts->radius.begin(), world.contacts->radius.begin() + bodies.count);
  list.reference = bodies.position;
  const auto search = [&] { buildNeighbourList(list, bodies, world.contacts->radius, 1); };
  const bool slow = method == ContactSearch::bruteForce;
  if (!slow) search();
  const auto before = list.counters;
  const double ns = slow ? timed(1, search) : timedOften(std::max(1, int(2e5 / vertices)), search);
  const SearchCounters& c = list.counters;
  const double n = vertices * static_cast<double>(c.searches - before.searches);
  const auto per = [&](std::uint64_t now, std::uint64_t then) { return static_cast<double>(now - then) / n; };
  std::printf("| %d | %s | %.2f | %.0f | %.3f | %.1f | %.0f | %.0f | %.2f | %.1f |\n", bodies.count, nameOf(method),
              skinShare, ns / vertices, ns / bodies.count / 1e6, per(c.pairs, before.pairs),
              per(c.distanceTests, before.distanceTests), per(c.binVisits, before.binVisits),
              per(c.rootTests, before.rootTests), per(c.boxTests, before.boxTests));
  std::fflush(stdout);
}

/// Prints the times [ns per vertex] of the other stages of a step.
void printStages(World& world) {
  Bodies& bodies = *world.bodies;
  Contacts& contacts = *world.contacts;
  const double vertices = double(bodies.count) * bodies.vertexCount();
  const int calls = std::max(1, int(1e6 / vertices));
  const auto eachBlock = [&](auto&& work) {
    const auto all = [&] {
      for (int i = 0; i < bodies.blockCount(); ++i) work(bodies.block(i, 0), i);
    };
    return timedOften(calls, all) / vertices;
  };
  const double internal = eachBlock([&](const BlockView& block, int) { advance(world.stages, bodies, block, 0); });
  evaluateForces(world);
  const double law =
      eachBlock([&](const BlockView&, int i) { addContactForces(contacts, bodies, i, world.clock.timeStep); });
  evaluateForces(world);
  const auto steps = world.clock.step, rebuilds = contacts.rebuilds;
  const double whole = timed(300, [&] { step(world); }) / vertices;
  std::printf("| %d | %.1f | %.1f | %.1f | %.0f |\n", bodies.count, internal, law, whole,
              static_cast<double>(world.clock.step - steps) /
                  static_cast<double>(std::max<std::uint64_t>(1, contacts.rebuilds - rebuilds)));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int largest = argc > 1 ? std::atoi(argv[1]) : 256;
  const Isa isa = argc > 2 ? parseIsa(argv[2]) : bestIsa();
  std::printf("%s, one thread, 162 vertices per cell; counters per vertex and search\n\n", name(isa));
  std::vector<World> worlds;
  for (int generations = 3; 1 << generations <= largest; ++generations) {
    worlds.push_back(makeWorld(organism(generations), {isa, 1}));
    while (!finished(worlds.back())) step(worlds.back());
  }
  printHead();
  for (const World& world : worlds)
    for (double skinShare : {0.15, 0.0})
      for (ContactSearch method : valuesOf<ContactSearch>())
        if (method != ContactSearch::bruteForce || (skinShare == 0 && world.bodies->count <= 256))
          printSearch(world, method, skinShare, isa);

  std::printf(
      "\n| cells | internal forces ns/v | contact law ns/v | whole step ns/v | steps per search "
      "|\n|--:|--:|--:|--:|--:|\n");
  for (World& world : worlds) printStages(world);

  // Cells lose half their mass at each division, and the longest stable step shrinks with the mass's root: a common
  // step is stable only up to some generation.
  std::printf("\nThe same organisms after 200 steps of 1/%.0f each, stable for 128 cells and not for 256:\n\n",
              1 / fixedStep);
  printHead();
  for (World& world : worlds) {
    if (world.bodies->count > 256) continue;
    for (int i = 0; i < 200; ++i) movePhysics(world, fixedStep);
    for (ContactSearch method : {ContactSearch::grid, ContactSearch::aabbTree}) printSearch(world, method, 0, isa);
  }
}
