// The whole state as one number, field by named field.
#include "simulation/measures.h"
#include "simulation/world.h"

namespace morula {

namespace {

void addPath(Hasher& h, const CellPath& p) { h.add(p.high()).add(p.low()).add(p.depth()); }

void addVectors(Hasher& h, const char* name, const Bodies& b, const Reals& array, int slot) {
  h.field(name);
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    const Vector a = b.read(array, slot, v);
    h.add(a.x).add(a.y).add(a.z);
  }
}

void addBody(Hasher& h, const Bodies& b, int slot) {
  h.field("vertex mass").add(b.vertexMass[slot]);
  h.field("rest scale").add(b.restScale[slot]);
  h.field("pressure constant").add(b.pressureConstant[slot]);
  addVectors(h, "position", b, b.position, slot);
  addVectors(h, "velocity", b, b.velocity, slot);
  addVectors(h, "acceleration", b, b.acceleration, slot);
}

}  // namespace

Hash stateHash(const World& world) {
  Hasher h;
  const Clock& c = world.clock;
  h.field("clock").add(c.time).add(c.step).add(c.timeStep).add(c.epochTime).add(c.epochStep);
  h.field("cells").add(std::uint64_t{world.cells.path.size()});
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    addPath(h, world.cells.path[i]);
    h.add(world.biology->describe(world.cells.state[i]))
        .add(world.cells.lastCycle[i])
        .add(world.cells.growth[i]);
    if (world.bodies) addBody(h, *world.bodies, world.bodies->slots[i]);
  }
  if (world.connections) {
    h.field("connections").add(std::uint64_t{world.connections->history.size()});
    for (const ConnectionRecord& r : world.connections->history) {
      addPath(h, r.a);
      addPath(h, r.b);
      h.add(r.made).add(r.released).add(r.cause);
    }
  }
  h.field("lineage").add(std::uint64_t{world.lineage.entries.size()});
  for (const LineageEntry& e : world.lineage.entries) {
    addPath(h, e.path);
    h.add(e.born).add(e.ended).add(e.bornStep).add(e.endedStep).add(static_cast<int>(e.fate));
    h.add(world.biology->describe(e.state));
  }
  return h.digest();
}

}  // namespace morula
