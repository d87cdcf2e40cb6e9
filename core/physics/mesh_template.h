#pragma once
// What all cells of a scene share: connectivity and rest lengths, laid out for the kernels.
#include <cstdint>
#include <vector>

#include "mesh/mesh.h"
#include "physics/block.h"

namespace morula {

struct MeshTemplate {
  Mesh mesh;  // the egg as loaded, in its size: what rest lengths refer to
  std::vector<std::int32_t> edges;
  std::vector<double>
      restLengths;  // [length], of the mesh as loaded [Nilsson 2008, §4.2.1]; one 0 behind the last
  std::vector<std::int32_t> ringStart;
  std::vector<RingStep> ring;
  double meanRestLength = 0;  // [length]

  int vertexCount() const { return static_cast<int>(mesh.vertices.size()); }
  int edgeCount() const { return static_cast<int>(edges.size() / 2); }
  TemplateView view() const;
};

/// Expects a closed manifold (checkClosedManifold).
MeshTemplate makeTemplate(const Mesh& mesh);

}  // namespace morula
