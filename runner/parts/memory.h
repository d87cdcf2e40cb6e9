#pragma once
// What a world's arrays hold, by the part that they are there for.
#include <cstddef>

#include "simulation/world.h"

namespace morula {

/// [byte] Sizes of arrays, not what their allocator has in reserve.
struct MemoryUse {
  std::size_t cells = 0;      // paths, states, lineage: what a lineage-only world has
  std::size_t mesh = 0;       // the template that all cells share
  std::size_t bodies = 0;     // places, velocities, accelerations, each cell's own numbers
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

}  // namespace morula
