// Without damping, accelerations follow from positions alone. Evaluating them again changes no bit, right after a step,
// a division, a death or a new time step. (Damping uses the velocity predicted for the step.)
#include "catch.h"
#include "simulation/move_physics.h"
#include "worlds.h"

using namespace morula;

namespace {

Scene undamped(Scene scene) {
  PhysicsParameters& p = scene.mechanics->physics;
  p.membrane.damping = p.drag = 0;
  p.shell.reset();  // the shell takes velocity from vertices after the forces
  p.growth.reset();
  if (scene.mechanics->contact) scene.mechanics->contact->damping = scene.mechanics->contact->viscosity = 0;
  return scene;
}

}  // namespace

TEST_CASE("Evaluating the forces again changes nothing") {
  Scene automatic = undamped(scenes::thesis());
  automatic.name = "thesis, automatic step";
  automatic.mechanics->physics.timeStep.reset();
  automatic.stop.time = 2.1;  // the thesis' contact law is too stiff for shorter steps
  for (const Scene& scene :
       {undamped(scenes::packed()), undamped(scenes::thesis()), automatic, undamped(scenes::life())}) {
    World world = makeWorld(scene);
    std::uint64_t changed = 0, checked = 0, divisions = 0;
    std::size_t held = 0;  // connections one step ago; a connection released in a step still pulled in it
    for (std::size_t cells = 0; !finished(world); step(world)) {
      const std::size_t holds = world.connections ? world.connections->active.size() : 0;
      const bool letGo = holds < std::exchange(held, holds);
      const bool born = world.cells.path.size() != cells;
      divisions += born;
      if (letGo || (!born && world.clock.step % 10 != 0)) continue;
      cells = world.cells.path.size();
      const Hash before = stateHash(world);
      evaluateForces(world);
      ++checked;
      changed += stateHash(world) != before;
    }
    CAPTURE(scene.name);
    CHECK(changed == 0);
    CHECK(checked > 10);
    CHECK(divisions >= 3);
  }
}
