#pragma once
// The memory of a world's arrays, by part, and a prediction of it: a world that would take more than
// Execution::memoryLimit is refused before it is made.
#include <cstddef>
#include <string>

#include "simulation/world.h"

namespace morula {

/// [byte] Sizes of arrays, not what their allocator has in reserve.
struct MemoryUse {
  std::size_t cells = 0;      // paths, states, lineage: what a lineage-only world has
  std::size_t mesh = 0;       // the template that all cells share
  std::size_t bodies = 0;     // positions, velocities, accelerations, each cell's own numbers
  std::size_t scratch = 0;    // of the physics, for each thread
  std::size_t snapshots = 0;  // contact: what each vertex shows
  std::size_t listRows = 0;   // contact: where each vertex's list stands
  std::size_t listPairs = 0;  // contact: who may touch whom
  std::size_t search = 0;     // contact: what finds them
  std::size_t connections = 0;

  std::size_t contact() const { return snapshots + listRows + listPairs + search; }
  std::size_t total() const { return cells + mesh + bodies + scratch + contact() + connections; }
};

MemoryUse measureMemory(const World& world);

/// [byte] What a run needs for so many cells that ever lived, living and dead, and for bodies with so many
/// vertices, empty lanes among them: the world, the copies that divisions and results make, and what finds
/// contacts, but not the lists of neighbours, which depend on where cells are.
double predictMemory(const Scene& scene, double cellsEver, double vertices);

/// [byte] What is left for the lists of neighbours under the world's memory limit. The world has contacts.
double memoryForLists(const World& world);

/// Throws NumericalError that names the cell, both numbers of bytes and what to change, if a run with so many
/// cells and vertices would take more than the world's memory limit.
void requireMemory(const World& world, const CellPath& cell, double cellsEver, double vertices);

/// Throws InputError if memory does not suffice for the cells that a scene begins with.
void requireMemoryForStart(const World& world);

/// "3.2 GB"
std::string bytesText(double bytes);

}  // namespace morula
