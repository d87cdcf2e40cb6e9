// Prints costs that can be counted instead of timed.
//
//   cost_program counts          steps, searches and pairs of two scenes: the same on every machine
//   cost_program build           what instructions depend on: the compiler, and whether it optimised
//   cost_program kernels         the names that `work` knows
//   cost_program work KERNEL ISA TURNS FOLDER
//                                does it so often, for a program that counts instructions, and prints the
//                                number of vertices in one turn; FOLDER keeps the packed cells
#include <iostream>
#include <map>

#include "bench/packed_world.h"
#include "contacts/contacts.h"
#include "scenario/scenario.h"
#include "scenes.h"
#include "simulation/move_physics.h"

using namespace morula;

namespace {

void count(const Scene& scene) {
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  const Contacts& c = *world.contacts;
  const auto line = [&](const char* what, std::uint64_t n) {
    std::cout << scene.name << ' ' << what << ' ' << n << '\n';
  };
  line("steps", world.clock.step);
  line("rebuilds", c.rebuilds);
  line("pair_evaluations", c.pairEvaluations);
  line("pairs_found", c.list.counters.pairs);
  line("distance_tests", c.list.counters.distanceTests);
}

std::string build() {
#ifdef __clang__
  std::string text = "clang " __clang_version__;
#else
  std::string text = "gcc " __VERSION__;
#endif
#if !defined(__OPTIMIZE__) || !defined(NDEBUG)
  text += " not optimised";
#endif
#ifdef __SANITIZE_ADDRESS__
  text += " with sanitizers";
#endif
  return text;
}

using Work = void (*)(World&);

void overBlocks(World& world, PhysicsKernels::Stage stage) {
  Bodies& b = *world.bodies;
  for (int i = 0; i < b.blockCount(); ++i) stage(b.mesh.view(), b.block(i, 0), b.kernelParameters);
}

void integrate(World& world) {
  Bodies& b = *world.bodies;
  if (b.acceleration[0] != 0) b.acceleration.assign(b.acceleration.size(), 0);  // only zero keeps its value
  for (int i = 0; i < b.blockCount(); ++i) {
    world.stages.drift(b.mesh.view(), b.block(i, 0), b.kernelParameters, world.clock.timeStep);
    kick(world.stages, b, b.block(i, 0), world.clock.timeStep);
  }
}

void findContactForces(World& world) {
  Bodies& b = *world.bodies;
  for (int i = 0; i < b.blockCount(); ++i) takeSnapshot(*world.contacts, b, b.block(i, 0), i);
  for (int i = 0; i < b.blockCount(); ++i) addContactForces(*world.contacts, b, i, world.clock.timeStep);
}

const std::map<std::string, Work>& works() {
  static const std::map<std::string, Work> all{
      {"internal",
       [](World& world) {
         overBlocks(world, world.stages.findTensions);
         overBlocks(world, world.stages.accumulateRings);
         overBlocks(world, world.stages.finishForces);
       }},
      {"integrate", integrate},
      {"integrate-alone", integrate},
      {"contact", findContactForces},
      {"contact-dry", findContactForces},
      {"choice", [](World& world) { choosePairs(*world.contacts, *world.bodies, 1); }},
      {"search",
       [](World& world) {
         world.contacts->listIsValid = false;
         refreshList(*world.contacts, *world.bodies, 1);
       }},
      {"step", [](World& world) { step(world); }},
      {"sixteen-steps-alone", [](World& world) { takeSteps(world, 16); }},
  };
  return all;
}

}  // namespace

// callgrind finds the code to count by this name.
extern "C" [[gnu::noinline]] void countedWork(Work work, World* world, int turns) {
  for (int i = 0; i < turns; ++i) work(*world);
}

int main(int argc, char** argv) {
  const std::string verb = argc > 1 ? argv[1] : "";
  if (verb == "counts") {
    count(scenes::packed());
    count(loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/unique-four.yaml").scene);
  } else if (verb == "build") {
    std::cout << build() << '\n';
  } else if (verb == "kernels") {
    for (const auto& [name, work] : works()) std::cout << name << '\n';
  } else if (verb == "work" && argc == 6 && works().contains(argv[2])) {
    // The world is two blocks of cells with coarse meshes, because programs that count are slow.
    const std::string_view kernel = argv[2];
    const bool alone = kernel.ends_with("alone"), dry = kernel.ends_with("dry");
    World world = makePackedWorld({.cells = 16, .level = 1, .viscosity = dry ? 0 : 0.3, .contact = !alone},
                                  {.isa = parseIsa(argv[3])}, argv[5], [](const std::string&) {});
    const Work work = works().at(argv[2]);
    work(world);  // one-time allocations are not counted
    countedWork(work, &world, std::atoi(argv[4]));
    std::cout << world.bodies->livingVertices << '\n';
  } else {
    std::cerr << "cost_program counts | build | kernels | work KERNEL ISA TURNS FOLDER\n";
    return 2;
  }
}
