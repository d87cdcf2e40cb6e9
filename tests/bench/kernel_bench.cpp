// Measures each kernel alone: kernel_bench --benchmark_filter=rings. `morula bench` measures kernels in whole steps.
// This is no test: it prints numbers and judges nothing.
#include <benchmark/benchmark.h>

#include "bench/packed_world.h"
#include "contacts/contacts.h"
#include "contacts/search.h"

using namespace morula;

namespace {

constexpr int cells = 64;

World& packed() {
  static World world = makePackedWorld({.cells = cells});
  return world;
}

/// Registers a benchmark named "WHAT/ISA".
template <class Run>
void add(const std::string& what, Isa isa, const Run& run) {
  benchmark::RegisterBenchmark((what + "/" + name(isa)).c_str(), run);
}

/// Runs a stage over all blocks; items are vertices.
template <class Stage>
void overBlocks(benchmark::State& state, const Stage& stage) {
  Bodies& b = *packed().bodies;
  for (auto _ : state)
    for (int i = 0; i < b.blockCount(); ++i) stage(b.mesh.view(), b.block(i, 0), b.kernelParameters);
  state.SetItemsProcessed(state.iterations() * cells * b.vertexCount());
}

void addStage(const std::string& what, Isa isa, PhysicsKernels::Stage stage) {
  add(what, isa, [=](benchmark::State& state) { overBlocks(state, stage); });
}

/// Adds a stage with a time step of 0, which moves nothing. Acceleration shares its place with force and is set to 0
/// first, so that kicks start without force.
void addTimedStage(const std::string& what, Isa isa, PhysicsKernels::TimedStage stage) {
  add(what, isa, [=](benchmark::State& state) {
    Bodies& b = *packed().bodies;
    const auto acceleration = b.acceleration;
    b.acceleration.assign(b.acceleration.size(), 0);
    overBlocks(state, [=](const TemplateView& mesh, const BlockView& block, const KernelParameters& p) {
      stage(mesh, block, p, 0);
    });
    b.acceleration = acceleration;
  });
}

void addContact(Isa isa, double viscosity) {
  add(viscosity > 0 ? "contact with viscosity" : "contact", isa, [=](benchmark::State& state) {
    World& world = packed();
    Contacts& c = *world.contacts;
    ContactParameters parameters = c.parameters;
    parameters.viscosity = viscosity;
    c.addForces = makeContacts(parameters, isa).addForces;
    const auto acceleration = world.bodies->acceleration;
    for (auto _ : state)
      for (int i = 0; i < world.bodies->blockCount(); ++i) addContactForces(c, *world.bodies, i, world.clock.timeStep);
    world.bodies->acceleration = acceleration;
    state.SetItemsProcessed(state.iterations() * cells * world.bodies->vertexCount());
    state.counters["pairs/vertex"] = double(c.list.pairs) / (cells * world.bodies->vertexCount());
  });
}

void addSearch(Isa isa, ContactSearch method) {
  add(std::string("search by ") + nameOf(method), isa, [=](benchmark::State& state) {
    const Bodies& bodies = *packed().bodies;
    Contacts c = makeContacts(packed().contacts->parameters, isa, {.method = method});
    resetContacts(c, bodies);
    for (auto _ : state) {
      c.listIsValid = false;
      refreshList(c, bodies, 1);
    }
    state.SetItemsProcessed(state.iterations() * cells * bodies.vertexCount());
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const Isa isa : availableIsas()) {
    const PhysicsKernels& k = physicsKernels(isa);
    addStage("springs", isa, k.findTensions);
    addStage("damped springs", isa, k.findDampedTensions);
    addStage("rings", isa, k.accumulateRings);
    // Pressure is benchmarked alone: forces add up, which changes no time.
    addStage("pressure", isa, k.addPressureForces);
    addStage("pressure and drag", isa, k.addPressureAndDragForces);
    addTimedStage("drift", isa, k.driftVelocityVerlet[int(ShellShape::none)]);
    addTimedStage("drift in a sphere", isa, k.driftVelocityVerlet[int(ShellShape::sphere)]);
    addTimedStage("kick", isa, k.kickVelocityVerlet[false]);
    addTimedStage("kick in a shell", isa, k.kickVelocityVerlet[true]);
    addContact(isa, 0);
    addContact(isa, 0.3);
    for (const ContactSearch method : valuesOf<ContactSearch>()) addSearch(isa, method);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
