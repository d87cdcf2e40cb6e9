#pragma once
// The bodies of all living cells: what the physics changes, in blocks of eight (block.h).
//
// A slot is a place in storage: lane s % 8 of block s / 8. Cells fill the slots in the order of lineage paths, so if
// all have one mesh, cell number i has slot i. Cells with a coarser mesh stand behind the others in blocks of their
// own, each mesh in whole blocks; Bodies::slots holds their slots. Slots follow from the living cells alone, so nothing
// depends on the history of births. Lanes without a cell hold a resting egg of enormous mass, which never moves.
#include <vector>

#include "base/aligned.h"
#include "base/reals.h"
#include "physics/block.h"
#include "physics/cell_model.h"
#include "physics/mesh_template.h"
#include "physics/parameters.h"

namespace morula {

/// One cell's state outside block storage.
struct Body {
  std::vector<Point> position;
  std::vector<Vector> velocity;
  double mass = 0;              // [mass] of the whole cell
  double restScale = 1;         // rest lengths over the template's
  double pressureConstant = 0;  // k_p [force·length]
  int meshLevel = 0;            // number of its mesh: 0 the egg's, 1 … the coarser ones of the scene
};

/// A block of eight lanes in storage.
struct BlockPlace {
  int meshLevel;  // level of its cells' mesh
  int firstLine;  // vertices of all blocks before it
  int liveLanes;  // cells in it
};

/// A mesh that cells may take instead of the finer one before it.
struct CoarserMesh {
  MeshTemplate mesh;
  std::vector<std::int32_t> nested;  // [vertex] number of the same vertex in the finer mesh
};

struct Bodies {
  // Constant
  PhysicsParameters parameters;
  KernelParameters kernelParameters;
  MeshTemplate mesh;                 // the egg's; a sphere's is its centre
  Mesh surface;                      // the mesh that draws a sphere, at scale 1; empty with other models
  std::vector<CoarserMesh> coarser;  // finer ones first; empty: all cells have the egg's mesh

  // Places of cells
  int count = 0;                   // living cells
  std::vector<int> slots;          // [cell] slots in the order of lineage paths
  std::vector<BlockPlace> blocks;  // coarser meshes behind finer ones
  int livingVertices = 0;          // vertices of all living cells

  // State: [block][vertex][xyz][lane]
  Reals position, velocity, acceleration;
  // Each cell's parameters, [slot], filled up to whole blocks
  AlignedVector<double> vertexMass, restScale, pressureConstant;
  AlignedVector<double> sag;  // [length] depth below the vertices of the surface that holds a cell's volume (sag.h)

  // Between the evaluations of a Runge–Kutta step (BlockView::substeps); empty with the other integrators
  Reals substeps;

  // Output of the last force evaluation, [slot]
  AlignedVector<double> volume;    // [length³]
  AlignedVector<double> pressure;  // [force/length²] inner minus outer

  // Scratch, one per thread
  struct Scratch {
    Reals predicted, gradient, coefficient, curvature;
  };
  std::vector<Scratch> scratch;

  const MeshTemplate& meshAt(int meshLevel) const { return meshLevel == 0 ? mesh : coarser[meshLevel - 1].mesh; }
  const MeshTemplate& meshOf(int slot) const { return meshAt(blocks[slot / blockLanes].meshLevel); }
  int vertexCount(int slot) const { return meshOf(slot).vertexCount(); }
  /// Number of vertices of every cell, in a scene with one mesh; throws BugError in others.
  int vertexCount() const;
  int blockCount() const { return static_cast<int>(blocks.size()); }
  int liveLanes(int block) const { return blocks[block].liveLanes; }
  int verticesPerLane(int block) const { return meshAt(blocks[block].meshLevel).vertexCount(); }
  /// Number of lines of all blocks; a line is one vertex of eight lanes.
  int lineCount() const { return static_cast<int>(position.size() / vertexStride); }
  /// Index of component x of a slot's vertex in position, velocity and acceleration; y and z follow at
  /// blockLanes.
  std::size_t at(int slot, int vertex) const {
    return std::size_t(blocks[slot / blockLanes].firstLine + vertex) * vertexStride + slot % blockLanes;
  }
  const CellModelKind& model() const { return kindOf(parameters.cell.model); }
  bool areSpheres() const { return !model().hasMesh; }
  Point vertex(int slot, int v) const { return read(position, slot, v); }
  Vector read(const Reals& a, int slot, int v) const {
    const std::size_t i = at(slot, v);
    return {a[i], a[i + blockLanes], a[i + 2 * blockLanes]};
  }
  void write(Reals& a, int slot, int v, const Vector& u) const {
    const std::size_t i = at(slot, v);
    a[i] = u.x, a[i + blockLanes] = u.y, a[i + 2 * blockLanes] = u.z;
  }
  double mass(int slot) const { return vertexMass[slot] * vertexCount(slot); }
  BlockView block(int index, int thread);
};

/// Returns what kernels read of the parameters, which must outlive it if the shell is a mesh.
KernelParameters kernelParametersOf(const PhysicsParameters& parameters);

/// Makes storage without cells, with `threads` sets of scratch. `coarser`: meshes of the egg's shape that cells may
/// take. The vertices of each are some of the vertices of the mesh before it.
Bodies makeBodies(const PhysicsParameters& parameters, const Mesh& egg, int threads,
                  const std::vector<Mesh>& coarser = {});

/// Returns the egg: the mesh as loaded, at rest.
Body makeEgg(const Bodies& bodies);

Body takeBody(const Bodies& bodies, int slot);

/// Returns a cell's surface [length]: its mesh, or a sphere's ball.
Mesh takeSurface(const Bodies& bodies, int slot);

/// Returns the mean [length] of a cell's vertices, which carry its mass.
Point measureCentre(const Bodies& bodies, int slot);

/// Sets the mass of a cell's vertices. Accelerations change so that forces stay.
void setVertexMass(Bodies& bodies, int slot, double mass);

/// Replaces all cells by `cells`, in order of lineage paths. Accelerations are zero until the next force evaluation.
void setBodies(Bodies& bodies, const std::vector<Body>& cells);

}  // namespace morula
