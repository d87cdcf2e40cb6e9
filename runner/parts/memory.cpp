#include "parts/memory.h"

namespace morula {

namespace {

template <class Array>
std::size_t bytesOf(const Array& array) {
  return array.size() * sizeof(array[0]);
}
std::size_t bytesOf(const Reals& array) { return array.bytes(); }

template <class... Arrays>
std::size_t bytes(const Arrays&... arrays) {
  return (bytesOf(arrays) + ... + 0);
}

std::size_t bytes(const PointTable& t) { return bytes(t.x, t.y, t.z, t.slot, t.halfReach, t.vertex); }

std::size_t searchBytes(const GridSearch& s) { return bytes(s.start, s.binOf) + bytes(s.points); }
std::size_t searchBytes(const SpatialHash& s) { return bytes(s.start, s.binOf) + bytes(s.points); }
std::size_t searchBytes(const BruteForce&) { return 0; }
std::size_t searchBytes(const TreeSearch& s) {
  std::size_t sum = bytes(s.boxes) + bytes(s.points);
  for (const TreeShape& shape : s.shapes) sum += bytes(shape.nodes, shape.order);
  for (const TreeSearch::Scratch& scratch : s.scratch) {
    sum += bytes(scratch.open);
    for (const auto& row : scratch.rows) sum += bytes(row);
  }
  return sum;
}

}  // namespace

MemoryUse measureMemory(const World& world) {
  MemoryUse m;
  const Cells& c = world.cells;
  m.cells = bytes(c.path, c.state, c.lastCycle, c.growth, c.entry) + bytes(world.lineage.entries);
  if (world.bodies) {
    const Bodies& b = *world.bodies;
    m.mesh = bytes(b.mesh.mesh.vertices, b.mesh.mesh.faces, b.mesh.edges, b.mesh.restLengths,
                   b.mesh.ringStart, b.mesh.ring);
    m.bodies = bytes(b.position, b.velocity, b.acceleration, b.substeps, b.vertexMass, b.restScale,
                     b.pressureConstant, b.volume, b.pressure, b.slots, b.blocks);
    for (const Bodies::Scratch& s : b.scratch) m.scratch += bytes(s.predicted, s.gradient, s.coefficient);
  }
  if (world.contacts) {
    const Contacts& k = *world.contacts;
    m.snapshots = bytes(k.radius, k.inverseRadiusSquared, k.rows, k.farthest, k.list.reference);
    m.listRows = bytes(k.list.firstSlice);
    m.listPairs = bytes(k.list.slices, k.list.indices);
    for (const BlockLists& lists : k.list.perBlock) {
      m.listRows += bytes(lists.begin, lists.length, lists.order, lists.place);
      m.listPairs += bytes(lists.neighbours);
    }
    m.search = bytes(k.list.halfReach) +
               std::visit([](const auto& search) { return searchBytes(search); }, k.list.search);
  }
  if (world.connections) m.connections = bytes(world.connections->history, world.connections->active);
  return m;
}

}  // namespace morula
