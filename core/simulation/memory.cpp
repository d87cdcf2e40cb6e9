
#include "simulation/memory.h"

#include "base/error.h"
#include "base/number_text.h"
#include "contacts/any_search.h"
#include "contacts/contacts.h"
#include "physics/integrator.h"
#include "physics/stages.h"

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

// [byte] A lineage entry, its copy in the results, its row in the database, its place in the picture of the tree.
constexpr double perCellEver = 400;

/// Returns the size [byte] of a vertex in storage.
double perVertex(const MechanicsScene& m) {
  const double vector = 3 * (m.physics.precision == Precision::binary64 ? 8 : 4);
  double bytes = 3 * vector;                                                     // place, velocity, acceleration
  bytes += 2 * sizeof(Vector);                                                   // Body, while cells divide
  if (kindOf(m.physics.integrator).evaluations > 1) bytes += 4 * vector;         // Bodies::substeps
  if (!m.contact && !m.connections && !m.physics.motility) bytes += 3 * vector;  // BodyCopy
  // Snapshot, NeighbourList::reference, PointTable, BlockLists.
  if (m.contact) bytes += sizeof(RowMemory) + vector + 6 * sizeof(double) + 6 * sizeof(std::int32_t);
  return bytes;
}

double storedVertices(const World& world) { return world.bodies ? double(world.bodies->lineCount()) * blockLanes : 0; }

/// Returns half a sentence about a lack of memory, or "" if there is enough.
std::string problemOf(const World& world, double cellsEver, double vertices) {
  const double bytes = predictMemory(world.model, cellsEver, vertices);
  if (bytes <= world.execution.memoryLimit) return "";
  return "would take " + bytesText(bytes) + " of memory, more than the limit of " +
         bytesText(world.execution.memoryLimit);
}

}  // namespace

std::string bytesText(double bytes) {
  if (bytes >= 1e9) return numberText(bytes / 1e9, 3) + " GB";
  return numberText(bytes / 1e6, 3) + " MB";
}

double predictMemory(const Scene& scene, double cellsEver, double vertices) {
  return cellsEver * perCellEver + (scene.mechanics ? vertices * perVertex(*scene.mechanics) : 0);
}

double memoryForLists(const World& world) {
  return world.execution.memoryLimit -
         predictMemory(world.model, double(world.lineage.entries.size()), storedVertices(world));
}

void requireMemory(const World& world, const CellPath& cell, double cellsEver, double vertices) {
  const std::string problem = problemOf(world, cellsEver, vertices);
  if (problem.empty()) return;
  throw NumericalError(
      cell.text(), world.clock.step,
      "its division " + problem + ": " + numberText(cellsEver, 15) + " cells have ever lived" +
          (world.bodies ? ", and the living have " + numberText(vertices, 15) + " vertices" : ""),
      std::string("stop earlier (stop.cells, stop.cycles, stop.time), let fewer cells divide (dna), ") +
          (world.bodies ? "take a coarser physics.mesh, " : "") + "or raise --memory-limit",
      Want::memory);
}

void requireMemoryForStart(const World& world) {
  if (!world.model.mechanics) return;
  const MechanicsScene& m = *world.model.mechanics;
  const std::size_t cells = world.cells.path.size();
  const double each = kindOf(m.physics.cell.model).hasMesh ? double(m.mesh.vertices.size()) : 1;
  const double lanes = double((cells + blockLanes - 1) / blockLanes * blockLanes);
  const std::string problem = problemOf(world, double(world.lineage.entries.size()), lanes * each);
  if (problem.empty()) return;
  const std::string key = world.model.cells.empty() ? "physics.mesh" : "cells";
  throw InputError(key + " " + std::to_string(cells) + (cells == 1 ? " cell of " : " cells of ") +
                       numberText(each, 15) + (each == 1 ? " vertex " : " vertices ") + problem +
                       "; take a coarser physics.mesh, begin with fewer cells, or raise --memory-limit",
                   Want::memory, key);
}

MemoryUse measureMemory(const World& world) {
  MemoryUse m;
  const Cells& c = world.cells;
  m.cells = bytes(c.path, c.state, c.lastCycle, c.growth, c.entry) + bytes(world.lineage.entries);
  if (world.bodies) {
    const Bodies& b = *world.bodies;
    m.mesh = bytes(b.mesh.mesh.vertices, b.mesh.mesh.faces, b.mesh.edges, b.mesh.restLengths, b.mesh.springWeights,
                   b.mesh.ringStart, b.mesh.ring);
    m.bodies = bytes(b.position, b.velocity, b.acceleration, b.substeps, b.vertexMass, b.restScale, b.pressureConstant,
                     b.sag, b.volume, b.pressure, b.slots, b.blocks);
    for (const Bodies::Scratch& s : b.scratch) m.scratch += bytes(s.predicted, s.gradient, s.coefficient, s.curvature);
  }
  if (world.contacts) {
    const Contacts& k = *world.contacts;
    m.snapshots = bytes(k.radius, k.inverseRadiusSquared, k.rows, k.farthest, k.deepest, k.acting.change,
                        k.acting.speeds, k.acting.marked, k.list.reference);
    for (const ActingPairs::OfBlock& block : k.acting.blocks) m.snapshots += bytes(block.ended);
    for (const auto* strengths : {&k.adhesion.ofPairs, &k.adhesion.perWork})
      for (const auto& ofBlock : *strengths) m.listPairs += bytes(ofBlock);
    m.snapshots += bytes(k.adhesion.saturation);
    for (const BlockLists& lists : k.list.perBlock) {
      for (const RowLists* rows : {static_cast<const RowLists*>(&lists), &lists.acting}) {
        m.listRows += bytes(rows->begin, rows->length);
        m.listPairs += bytes(rows->neighbours);
      }
      m.listRows += bytes(lists.chosen, lists.place, lists.order, lists.ofLength);
      m.listPairs += bytes(lists.slices, lists.indices);
    }
    m.search = bytes(k.list.halfReach) +
               std::visit([](const auto& search) { return searchBytes(search); }, k.list.search->way);
  }
  if (world.connections) m.connections = bytes(world.connections->history, world.connections->active);
  return m;
}

}  // namespace morula
