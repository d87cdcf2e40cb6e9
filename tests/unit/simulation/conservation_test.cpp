// Without shell and drag no external force acts on the cells: momentum is conserved, through collisions with viscosity
// too.
#include "catch.h"
#include "simulation/move_physics.h"
#include "worlds.h"

using namespace morula;

namespace {

double sizeOfMomenta(const World& world) {
  double sum = 0;
  for (int slot = 0; slot < world.bodies->count; ++slot) sum += norm(momentumOf(*world.bodies, slot));
  return sum;
}

}  // namespace

TEST_CASE("Two to eight cells collide, with viscosity, and their momentum drifts by no more than 1e-12") {
  for (const ContactParameters& contact : {scenes::pairContact, scenes::pairContactWithViscosity})
    for (int count : {2, 3, 5, 8}) {
      Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
      scene.mechanics->contact = contact;
      World world = worldOf(scene, flyingCells(scene.mechanics->mesh, count, 2.3, 1));
      const Vector before = momentumOf(*world.bodies);
      const double size = sizeOfMomenta(world);
      std::vector<Vector> each;
      for (int slot = 0; slot < count; ++slot) each.push_back(momentumOf(*world.bodies, slot));
      Worst drift, exchanged;
      bool touched = false;
      while (world.clock.time < 1) {
        step(world);
        drift.see(norm(momentumOf(*world.bodies) - before) / size);
        touched = touched || world.contacts->list.pairs > 0;
      }
      for (int slot = 0; slot < count; ++slot) exchanged.see(norm(momentumOf(*world.bodies, slot) - each[slot]));
      CAPTURE(count, contact.viscosity, world.clock.step);
      CHECK(touched);
      CHECK(exchanged > 0.3);
      CHECK(drift <= 1e-12);
    }
}

TEST_CASE("Every integrator keeps the momentum of colliding cells to 1e-12") {
  for (Integrator integrator : {Integrator::thesisVerlet, Integrator::explicitEuler, Integrator::symplecticEuler,
                                Integrator::rungeKutta4, Integrator::xpbd}) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
    scene.mechanics->contact = scenes::pairContactWithViscosity;
    scene.mechanics->physics.integrator = integrator;
    // Explicit Euler is refused without drag, and drag takes momentum. The test is about the other forces.
    scene.mechanics->physics.drag = integrator == Integrator::explicitEuler ? 1e-13 : 0;
    if (integrator == Integrator::xpbd) scene.mechanics->physics.substeps = 3;
    World world = worldOf(scene, flyingCells(scene.mechanics->mesh, 3, 2.3, 1));
    world.clock.timeStep = 0x1p-11;
    const Vector before = momentumOf(*world.bodies), alone = momentumOf(*world.bodies, 0);
    const double size = sizeOfMomenta(world);
    Worst drift;
    for (int i = 0; i < 2000; ++i) {
      movePhysics(world, world.clock.timeStep);  // without drag no step of explicit Euler is stable
      drift.see(norm(momentumOf(*world.bodies) - before) / size);
    }
    CAPTURE(static_cast<int>(integrator));
    CHECK(norm(momentumOf(*world.bodies, 0) - alone) > 0.3);
    CHECK(drift <= 1e-12);
  }
}

TEST_CASE("A division keeps mass and momentum, and adhesion too") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  scene.mechanics->division.otherwise.plane = DivisionPlane::random;
  scene.mechanics->connections = ConnectionParameters{};
  World world = makeWorld(scene);
  Bodies& b = *world.bodies;
  for (int v = 0; v < b.vertexCount(); ++v) {
    const Vector u = b.read(b.velocity, 0, v);
    b.write(b.velocity, 0, v, {0.3 + 0.1 * noise(static_cast<std::uint32_t>(v)), -0.2, u.z});
  }
  const Vector before = momentumOf(*world.bodies);
  Worst drift, massDrift;
  while (!finished(world)) {
    step(world);
    drift.see(norm(momentumOf(*world.bodies) - before) / norm(before));
    double mass = 0;
    for (int slot = 0; slot < b.count; ++slot) mass += b.mass(slot);
    massDrift.see(std::abs(mass - 1));
  }
  CHECK(world.cells.path.size() == 8);
  CHECK(drift <= 1e-12);
  CHECK(massDrift <= 1e-14);
}

TEST_CASE("A collision takes energy and never gives any") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(2));
  scene.mechanics->contact = scenes::pairContact;
  World world = worldOf(scene, flyingCells(scene.mechanics->mesh, 2, 2.3, 0.5));
  const double before = measureWorld(world).at("kinetic_energy");
  Worst largest;
  while (world.clock.time < 4) {
    step(world);
    largest.see(measureWorld(world).at("kinetic_energy"));
  }
  CHECK(measureWorld(world).at("kinetic_energy") < before);
  CHECK(largest < 1.1 * before);  // gas and springs begin close to rest and lend some energy
}

TEST_CASE("Cells made by shape matching keep their momentum through collisions and divisions") {
  Scene scene = scenes::byShapes(scenes::withBodies(scenes::everybodyDivides, 3));
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  scene.mechanics->division.otherwise.plane = DivisionPlane::random;
  scene.mechanics->connections = ConnectionParameters{};
  scene.cells = {{.at = {-1, 0.1, 0}, .velocity = {0.5, 0, 0}}, {.at = {1, 0, 0}, .velocity = {-0.25, 0.1, 0}}};
  World world = makeWorld(scene);
  const Vector before = momentumOf(*world.bodies);
  Worst drift;
  while (!finished(world)) {
    step(world);
    drift.see(norm(momentumOf(*world.bodies) - before));
  }
  CHECK(world.cells.path.size() == 16);
  CHECK(norm(before) > 0.2);
  CHECK(drift <= 1e-12);
}
