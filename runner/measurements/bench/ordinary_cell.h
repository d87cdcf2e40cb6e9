#pragma once
// The inner forces of a cell as most programs compute them: an array of vertex structs, a loop over springs and one
// over faces, one number at a time. Morula's kernels are compared with it, in speed and in tests.
#include <cstdint>
#include <vector>

#include "physics/bodies.h"

namespace morula {

struct OrdinaryCell {
  struct Vertex {
    Point position;
    Vector velocity, force;
    double mass;
  };
  struct Spring {
    std::int32_t first, second;
    double restLength, weight;
  };
  std::vector<Vertex> vertices;
  std::vector<Spring> springs;
  std::vector<Face> faces;
  double pressureConstant = 0;
  double volume = 0, pressure = 0;  // at the last evaluation
};

OrdinaryCell makeOrdinaryCell(const MeshTemplate& mesh, const Body& body);

/// Computes springs, pressure and drag on every vertex [Nilsson 2008, eq. 4.2 to 4.5].
void findForces(OrdinaryCell& cell, const PhysicsParameters& physics);

}  // namespace morula
