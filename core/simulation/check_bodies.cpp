// What makes the physics stop. A number that is finite and wrong is a failure too.
#include "base/error.h"
#include "base/number_text.h"
#include "simulation/stages.h"

namespace morula {

void checkBodies(const World& world) {
  const Bodies& b = *world.bodies;
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    const double volume = b.volume[slot];
    // Written so that a NaN fails: it does not compare.
    if (volume > 0 && volume < 1e300 && b.pressure[slot] < 1e300) continue;
    throw NumericalError(
        world.cells.path[cell].text(), world.clock.step,
        volume <= 0 ? "its volume is " + numberText(volume) + ": the cell is inside out"
                    : "its volume is not finite",
        "lower physics.time_step (now " + exactText(world.clock.timeStep) +
            ") or the stiffness that drives it: physics.membrane.stiffness, physics.pressure.constant, "
            "physics.contact.stiffness");
  }
}

}  // namespace morula
