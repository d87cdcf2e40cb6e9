#pragma once
// Connectivity: which vertices are neighbours in a closed mesh. It never changes during a run: daughters keep their
// mother's template, so that cells share lanes and a kernel reads one ring structure for all of them.
#include <array>
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// One mesh template's connectivity, shared by all cells that have it.
///
///        r1 ---- r0        The ring of vertex i: its neighbours, counter-clockwise seen from outside.
///       /  \    /  \       Each neighbour rk comes with the edge (i, rk) and begins the face
///     r2 --- i --- r5      (i, rk, rk+1); the last face is (i, r5, r0).
///       \  /    \  /
///        r3 ---- r4
struct Connectivity {
  int vertexCount = 0, edgeCount = 0;
  std::vector<std::array<int, 2>> edges;  // the smaller index first; sorted
  std::vector<int> ringStart;             // vertexCount + 1: the ring of i is [ringStart[i], ringStart[i + 1])
  std::vector<int> ringVertex;            // the neighbours, from the one with the smallest index on
  std::vector<int> ringEdge;              // the edge to that neighbour
  std::vector<Face> faces;
};

/// Throws BugError if the rings cannot be made, because the mesh does not pass checkClosedManifold.
Connectivity makeConnectivity(const Mesh& mesh);

}  // namespace morula
