#include "engines/bullet_run.h"

#include "mesh/mesh_measures.h"

namespace morula {
namespace {

BulletScene sceneOf(const World& world, Baseline baseline, double margin, Integrator integrator) {
  const MechanicsScene& mechanics = *world.model.mechanics;
  BulletScene scene;
  scene.baseline = baseline;
  scene.mesh = mechanics.mesh;
  scene.physics = mechanics.physics;
  scene.physics.integrator = integrator;
  for (const int slot : world.bodies->slots) scene.cells.push_back(takeBody(*world.bodies, slot));
  scene.timeStep = world.clock.timeStep;
  scene.contact = mechanics.contact.has_value();
  scene.margin = margin * mechanics.physics.cell.radius;
  return scene;
}

}  // namespace

World makeBulletStart(Scenario scenario) {
  std::optional<double> asked;
  std::swap(asked, scenario.scene.mechanics->physics.timeStep);
  scenario.scene.mechanics->physics.precision = Precision::binary64;
  World world = makeScenarioWorld(scenario, {});
  world.clock.timeStep = static_cast<float>(asked.value_or(world.clock.timeStep));
  world.contacts.reset();
  return world;
}

BulletRun::BulletRun(const Scenario& scenario, Baseline baseline, double margin, Integrator integrator)
    : world_(makeBulletStart(scenario)), bullet_(makeBulletWorld(sceneOf(world_, baseline, margin, integrator))) {}

void BulletRun::step() {
  bullet_->step();
  Clock& clock = world_.clock;
  clock.time = static_cast<double>(++clock.step) * clock.timeStep;
  take(bullet_->cells());
}

namespace {

void placeCell(Bodies& b, int slot, const std::vector<Point>& shape) {
  for (int v = 0; v < b.vertexCount(slot); ++v) b.write(b.position, slot, v, shape[static_cast<std::size_t>(v)]);
  b.volume[slot] = measureVolume(shape, b.meshOf(slot).mesh.faces);
  b.pressure[slot] = b.pressureConstant[slot] / b.volume[slot] - b.parameters.pressure.outside;
}

}  // namespace

void placeCells(World& world, const std::vector<std::vector<Point>>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) placeCell(*world.bodies, world.bodies->slots[i], shapes[i]);
}

void BulletRun::take(const std::vector<Body>& cells) {
  Bodies& b = *world_.bodies;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int slot = b.slots[i];
    placeCell(b, slot, cells[i].position);
    for (int v = 0; v < b.vertexCount(slot); ++v)
      b.write(b.velocity, slot, v, cells[i].velocity[static_cast<std::size_t>(v)]);
  }
}

}  // namespace morula
