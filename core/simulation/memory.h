#pragma once
// The memory of a world's arrays, by part, and its prediction. A world that would take more than Execution::memoryLimit
// is refused before it is made.
#include <cstddef>
#include <string>

#include "state/world.h"

namespace morula {

/// [byte] Sizes of arrays, not what their allocator has in reserve.
struct MemoryUse {
  std::size_t cells = 0;      // paths, states, lineage: what a lineage-only world has
  std::size_t mesh = 0;       // the template that all cells share
  std::size_t bodies = 0;     // positions, velocities, accelerations, each cell's own numbers
  std::size_t scratch = 0;    // of the physics, for each thread
  std::size_t snapshots = 0;  // contact: snapshots of vertices
  std::size_t listRows = 0;   // contact: places of vertices' lists
  std::size_t listPairs = 0;  // contact: lists of neighbours
  std::size_t search = 0;     // contact: the search for neighbours
  std::size_t connections = 0;

  std::size_t contact() const { return snapshots + listRows + listPairs + search; }
  std::size_t total() const { return cells + mesh + bodies + scratch + contact() + connections; }
};

MemoryUse measureMemory(const World& world);

/// Predicts the memory [byte] of a run for `cellsEver` cells, living and dead, and for bodies with `vertices` vertices,
/// including those of empty lanes. Counts the world, the copies that divisions and results make, and the search for
/// contacts, but not the lists of neighbours, which depend on where cells are.
double predictMemory(const Scene& scene, double cellsEver, double vertices);

/// Returns the memory [byte] left for lists of neighbours under the world's memory limit. Requires contacts.
double memoryForLists(const World& world);

/// Throws NumericalError if a run with this many cells and vertices would take more than the world's memory limit. The
/// error names the cell, both numbers of bytes and what to change.
void requireMemory(const World& world, const CellPath& cell, double cellsEver, double vertices);

/// Throws InputError if memory does not suffice for the cells that a scene begins with.
void requireMemoryForStart(const World& world);

/// Returns a number of bytes as text: "3.2 GB".
std::string bytesText(double bytes);

}  // namespace morula
