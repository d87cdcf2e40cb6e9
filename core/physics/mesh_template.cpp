#include "physics/mesh_template.h"

#include "mesh/connectivity.h"

namespace morula {

TemplateView MeshTemplate::view() const {
  return {vertexCount(), edgeCount(), edges.data(), restLengths.data(), ringStart.data(), ring.data()};
}

MeshTemplate makeTemplate(const Mesh& mesh) {
  const Connectivity c = makeConnectivity(mesh);
  MeshTemplate t;
  t.mesh = mesh;
  double sum = 0;
  for (const auto& [first, second] : c.edges) {
    t.edges.insert(t.edges.end(), {first, second});
    t.restLengths.push_back(norm(mesh.vertices[second] - mesh.vertices[first]));
    sum += t.restLengths.back();
  }
  t.meanRestLength = sum / c.edgeCount;
  t.restLengths.push_back(0);  // of the slack edge that evens out odd rings
  for (int v = 0; v < c.vertexCount; ++v) {
    t.ringStart.push_back(static_cast<std::int32_t>(t.ring.size()));
    for (int k = c.ringStart[v]; k < c.ringStart[v + 1]; ++k)
      t.ring.push_back({c.ringVertex[k] * vertexStride, c.ringEdge[k] * blockLanes});
    if ((c.ringStart[v + 1] - c.ringStart[v]) % 2 == 1)
      t.ring.push_back({t.ring.back().vertexOffset, c.edgeCount * blockLanes});
  }
  t.ringStart.push_back(static_cast<std::int32_t>(t.ring.size()));
  return t;
}

}  // namespace morula
