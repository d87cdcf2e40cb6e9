#pragma once
// The bodies of all living cells: what the physics changes, in blocks of eight (block.h).
//
// Slot s is cell number s in the order of lineage paths, in block s / 8, lane s % 8. Slots follow from the
// living cells alone, so nothing depends on the history of births. Lanes without a cell hold a resting egg of
// enormous mass, which never moves.
#include <vector>

#include "base/aligned.h"
#include "base/isa.h"
#include "physics/block.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

/// One cell's body on its own: what division makes and death takes.
struct Body {
  std::vector<Point> position;
  std::vector<Vector> velocity;
  double mass = 0;              // [mass] of the whole cell
  double restScale = 1;         // rest lengths over the template's
  double pressureConstant = 0;  // k_p [force·length]
};

struct Bodies {
  // Constant
  PhysicsParameters parameters;
  KernelParameters kernelParameters;
  MeshTemplate mesh;

  // State: [block][vertex][xyz][lane]
  int count = 0;  // living cells
  AlignedVector<double> position, velocity, acceleration;
  // Each cell's parameters, [slot], filled up to whole blocks
  AlignedVector<double> vertexMass, restScale, pressureConstant;

  // Output of the last force evaluation, [slot]
  AlignedVector<double> volume;    // [length³]
  AlignedVector<double> pressure;  // [force/length²] inner minus outer

  // Scratch, one per thread
  struct Scratch {
    AlignedVector<double> predicted, gradient, coefficient;
  };
  std::vector<Scratch> scratch;

  int vertexCount() const { return mesh.vertexCount(); }
  int blockCount() const { return (count + blockLanes - 1) / blockLanes; }
  int liveLanes(int block) const {
    return count - block * blockLanes < blockLanes ? count - block * blockLanes : blockLanes;
  }
  /// Where component x of a vertex of a slot stands in position, velocity and acceleration; y and z follow at
  /// blockLanes.
  std::size_t at(int slot, int vertex) const {
    return (std::size_t(slot / blockLanes) * vertexCount() + vertex) * vertexStride + slot % blockLanes;
  }
  Point vertex(int slot, int v) const { return read(position, slot, v); }
  Vector read(const AlignedVector<double>& a, int slot, int v) const {
    const double* p = &a[at(slot, v)];
    return {p[0], p[blockLanes], p[2 * blockLanes]};
  }
  double mass(int slot) const { return vertexMass[slot] * vertexCount(); }
  std::size_t blockSize() const { return std::size_t(vertexCount()) * vertexStride; }
  BlockView block(int index, int thread);
};

/// No cells yet; `threads` sets of scratch.
Bodies makeBodies(const PhysicsParameters& parameters, const Mesh& egg, int threads);

/// The egg: the mesh as loaded, at rest.
Body makeEgg(const Bodies& bodies);

Body takeBody(const Bodies& bodies, int slot);

/// The mean of a cell's vertices, which carry its mass. [length]
Point measureCentre(const Bodies& bodies, int slot);

/// Replaces all cells. Accelerations are zero until the next force evaluation.
void setBodies(Bodies& bodies, const std::vector<Body>& cells);

}  // namespace morula
