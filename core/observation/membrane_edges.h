#pragma once
// The springs of a cell's membrane, one by one, for measures; kernels have lists of their own.
#include "physics/bodies.h"

namespace morula {

struct MembraneEdge {
  int i, j;       // vertices
  Vector d;       // [length] from i to j
  Vector rate;    // [length/time] how d changes
  double rest;    // [length]
  double weight;  // [1] of k_s and k_d (MembraneParameters::springs)
};

/// Calls visit(MembraneEdge) for every edge of a cell once.
template <class Visit>
void forEachEdge(const Bodies& b, int slot, Visit&& visit) {
  const MeshTemplate& mesh = b.meshOf(slot);
  const auto visitEdge = [&](int i, int j, double weight) {
    visit(MembraneEdge{i, j, b.vertex(slot, j) - b.vertex(slot, i),
                       b.read(b.velocity, slot, j) - b.read(b.velocity, slot, i),
                       b.restScale[slot] * norm(mesh.mesh.vertices[i] - mesh.mesh.vertices[j]), weight});
  };
  for (std::size_t e = 0; e < mesh.springWeights.size(); ++e)
    visitEdge(mesh.edges[2 * e], mesh.edges[2 * e + 1], mesh.springWeights[e]);
  if (!mesh.springWeights.empty()) return;
  for (const Face& face : mesh.mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const int i = face[k], j = face[(k + 1) % 3];
      if (i < j) visitEdge(i, j, 1);  // in one of its two faces an edge runs upwards
    }
}

}  // namespace morula
