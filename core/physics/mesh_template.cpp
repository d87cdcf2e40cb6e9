#include "physics/mesh_template.h"

#include "mesh/connectivity.h"
#include "mesh/measures.h"

namespace morula {

TemplateView MeshTemplate::view() const {
  return {.vertexCount = vertexCount(),
          .edgeCount = edgeCount(),
          .edges = edges.data(),
          .restLengths = restLengths.data(),
          .ringStart = ringStart.data(),
          .ring = ring.data(),
          .ringShare = ringShare.data(),
          .restShape = rest.vertices.data(),
          .restInverse = rest.inverse.data(),
          .restVolume = rest.volume};
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
    for (int k = c.ringStart[v]; k < c.ringStart[v + 1]; ++k) {
      const int neighbour = c.ringVertex[k];
      t.ring.push_back({neighbour * vertexStride, c.ringEdge[k] * blockLanes});
      t.ringShare.push_back(1.0 / (c.ringStart[neighbour + 1] - c.ringStart[neighbour]));
    }
    if ((c.ringStart[v + 1] - c.ringStart[v]) % 2 == 1) {
      t.ring.push_back({t.ring.back().vertexOffset, c.edgeCount * blockLanes});
      t.ringShare.push_back(0);
    }
  }
  t.ringStart.push_back(static_cast<std::int32_t>(t.ring.size()));
  return t;
}

RestShape makeRestShape(const Mesh& mesh) {
  RestShape rest;
  rest.volume = measureVolume(mesh.vertices, mesh.faces);
  const Point centre = measureCentroid(mesh.vertices);
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (const Point& x : mesh.vertices) {
    const Vector q = x - centre;
    rest.vertices.insert(rest.vertices.end(), {q.x, q.y, q.z});
    xx += q.x * q.x, xy += q.x * q.y, xz += q.x * q.z;
    yy += q.y * q.y, yz += q.y * q.z, zz += q.z * q.z;
  }
  const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
  const double determinant = xx * a + xy * b + xz * c;
  rest.inverse = {a, b, c, xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
  for (double& cofactor : rest.inverse) cofactor /= determinant;
  return rest;
}

MeshTemplate makeCentre(double diameter) {
  MeshTemplate t;
  t.mesh.vertices = {Point{}};
  t.restLengths = {0};
  t.ringStart = {0, 0};
  t.meanRestLength = diameter;
  return t;
}

}  // namespace morula
