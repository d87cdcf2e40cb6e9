// Ends a run with a NumericalError: for numbers that are not finite, and for finite ones that are impossible.
#include "simulation/check_bodies.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "base/number_text.h"
#include "contacts/contact_surface.h"
#include "contacts/contacts.h"
#include "contacts/pair_energy.h"
#include "mesh/distance.h"
#include "mesh/mesh_measures.h"
#include "observation/observation.h"
#include "simulation/body_failure.h"
#include "state/state_fields.h"

namespace morula {

namespace {

/// How far a cell's fastest vertex is from where the list was built.
double farthestMove(const World& world, int slot) {
  const Bodies& b = *world.bodies;
  const RowMemory* rows = &world.contacts->rows[b.blocks[slot / blockLanes].firstLine * blockLanes + slot % blockLanes];
  double square = 0;
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    const SnapshotRow row = readRow(rows[v * blockLanes], b.parameters.precision);
    const Vector move = Point{row.x, row.y, row.z} - b.read(world.contacts->list.reference, slot, v);
    square = std::max(square, dot(move, move));
  }
  return std::sqrt(square);
}

}  // namespace

void checkReach(const World& world) {
  const Contacts& c = *world.contacts;
  const Bodies& b = *world.bodies;
  if (!c.listIsValid) return;               // no cell has moved since cells were born
  const double before = 0.5 * c.list.skin;  // otherwise the list would have been built anew
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    const double most = before + c.radius[slot];
    if (!(c.farthest[slot / blockLanes] > most * most)) continue;
    const double move = farthestMove(world, slot);
    if (!(move > most && move < 1e300)) continue;  // another cell of its block, or checkBodies will see it
    const double timeStep = powerOfTwoBelow(world.clock.timeStep * maxFlight * (c.radius[slot] / move));
    BodyFailure failure(world.cells.path[cell].text(), world.clock.step,
                        "a vertex moves by " + numberText(move) + " in one step, farther than the " +
                            numberText(c.radius[slot]) + " that contacts reach: cells would pass through each other",
                        "use physics.time_step: " + exactText(timeStep) +
                            ", or less, or lower what drives it: speeds (cells: velocity), physics.contact.viscosity");
    failure.timeStep = timeStep;
    throw failure;
  }
}

namespace {

/// Throws if surfaces are deeper in each other than contacts hold them apart.
void checkDepth(const World& world) {
  const Contacts& c = *world.contacts;
  if (std::ranges::all_of(c.deepest, [](double held) { return held <= deepestHeld; })) return;
  const Bodies& b = *world.bodies;
  const std::vector<PairSum> pairs = sumPairs(c, b);
  const PairSum& deepest = *std::ranges::max_element(pairs, {}, &PairSum::deepest);
  const auto nameOf = [&](int slot) {
    return world.cells.path[std::ranges::find(b.slots, slot) - b.slots.begin()].text();
  };
  throw BodyFailure(nameOf(deepest.slot), world.clock.step,
                    "it is pressed into cell " + nameOf(deepest.other) + ", more than the " +
                        numberText(c.radius[deepest.slot] * std::sqrt(deepestBulk)) +
                        " that contacts hold surfaces apart over: they would pass through each other",
                    "raise physics.contact.stiffness, take a finer physics.mesh, move cells apart (cells: at), or "
                    "lower what drives them into each other: speeds (cells: velocity), physics.pressure, connections");
}

}  // namespace

void checkBodies(const World& world) {
  const Bodies& b = *world.bodies;
  if (world.contacts) checkDepth(world);
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    const double volume = b.volume[slot];
    if (isSound(volume, b.pressure[slot])) continue;
    throw BodyFailure(
        world.cells.path[cell].text(), world.clock.step,
        volume <= 0 ? "its volume is " + numberText(volume) + ": the cell is inside out" : "its volume is not finite",
        "check physics.time_step (now " + exactText(world.clock.timeStep) +
            "), the start of the cells (cells: velocity, stretch), physics.pressure.constant over "
            "physics.pressure.outside, as compared with the mesh's volume, and the forces of physics.contact and "
            "connections");
  }
}

void checkStart(const World& world) {
  const Bodies& b = *world.bodies;
  if (b.count < 2 || !world.contacts || world.contacts->parameters.law != ContactLaw::pair || b.areSpheres()) return;
  std::vector<Mesh> surfaces;
  std::vector<Box> boxes;
  for (int cell = 0; cell < b.count; ++cell) {
    surfaces.push_back(takeContactSurface(world.contacts.get(), b, b.slots[cell]));
    boxes.push_back(measureBox(surfaces.back().vertices));
  }
  for (int i = 0; i < b.count; ++i)
    for (int j = i + 1; j < b.count; ++j) {
      const double most =
          std::sqrt(deepestBulk) * std::min(world.contacts->radius[b.slots[i]], world.contacts->radius[b.slots[j]]);
      const auto share = [&](double Point::*along) {
        return std::min(boxes[i].high.*along, boxes[j].high.*along) -
               std::max(boxes[i].low.*along, boxes[j].low.*along);
      };
      if (std::min({share(&Point::x), share(&Point::y), share(&Point::z)}) <= most) continue;
      const double depth = std::max(measureDepth(surfaces[i], surfaces[j]), measureDepth(surfaces[j], surfaces[i]));
      if (depth <= most) continue;
      throw BodyFailure(
          world.cells.path[j].text(), 0,
          "it begins " + numberText(depth) + " deep in cell " + world.cells.path[i].text() + ", more than the " +
              numberText(most) + " that contacts on this mesh hold surfaces apart over: they would stay in each other",
          "move them apart (cells: at), or take a coarser physics.mesh or a larger physics.contact.radius");
    }
}

}  // namespace morula
