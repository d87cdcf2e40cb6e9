#include "physics/mesh_template.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "base/maths.h"
#include "mesh/connectivity.h"
#include "mesh/mesh_measures.h"

namespace morula {

TemplateView MeshTemplate::view() const {
  return {.vertexCount = vertexCount(),
          .edgeCount = edgeCount(),
          .edges = edges.data(),
          .restLengths = restLengths.data(),
          .springWeights = springWeights.empty() ? nullptr : springWeights.data(),
          .ringStart = ringStart.data(),
          .ring = ring.data(),
          .ringShare = ringShare.data(),
          .bendingWeights = bending.weights.data(),
          .inverseAreas = bending.inverseAreas.data(),
          .restShape = rest.vertices.data(),
          .restInverse = rest.inverse.data(),
          .restVolume = rest.volume};
}

namespace {

/// Measures MeshTemplate::unevenness of a closed mesh.
double measureUnevenness(const Mesh& mesh) {
  std::vector<Vector> gradient(mesh.vertices.size());  // 6 ∇V
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 3; ++k)
      gradient[face[k]] += cross(mesh.vertices[face[(k + 1) % 3]], mesh.vertices[face[(k + 2) % 3]]);
  double sum = 0;
  for (const Vector& g : gradient) sum += dot(g, g) / 36;
  const double radius = cubeRoot(3 * measureVolume(mesh.vertices, mesh.faces) / (4 * std::numbers::pi));
  const double area = 4 * std::numbers::pi * radius * radius;
  return std::max(double(gradient.size()) * sum / (area * area), 1.0);
}

/// Returns the radius [length] of the sphere on which all vertices lie; absent if there is none.
std::optional<double> radiusOfSphere(const std::vector<Point>& vertices) {
  const Point centre = measureCentroid(vertices);
  const double radius = norm(vertices[0] - centre);
  const auto isNear = [&](const Point& x) { return std::abs(norm(x - centre) - radius) <= 1e-9 * radius; };
  return std::ranges::all_of(vertices, isNear) ? std::optional(radius) : std::nullopt;
}

}  // namespace

double measureSag(const Mesh& mesh) {
  if (const auto radius = radiusOfSphere(mesh.vertices))
    return *radius - cubeRoot(3 * measureVolume(mesh.vertices, mesh.faces) / (4 * std::numbers::pi));
  const Connectivity c = makeConnectivity(mesh);
  std::vector<Vector> gradient(mesh.vertices.size());  // 6 ∇V
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 3; ++k)
      gradient[face[k]] += cross(mesh.vertices[face[(k + 1) % 3]], mesh.vertices[face[(k + 2) % 3]]);
  double sum = 0;
  for (int v = 0; v < c.vertexCount; ++v) {
    Vector toRing{};
    for (int k = c.ringStart[v]; k < c.ringStart[v + 1]; ++k)
      toRing += mesh.vertices[c.ringVertex[k]] - mesh.vertices[v];
    const double size = norm(gradient[v]) * (c.ringStart[v + 1] - c.ringStart[v]);
    if (size > 0) sum -= dot(toRing, gradient[v]) / size;
  }
  return std::max(0.25 * sum / c.vertexCount, 0.0);
}

MeshTemplate makeTemplate(const Mesh& mesh, Springs springs) {
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
  t.restLengths.push_back(0);  // for the slack edge that evens out odd rings
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
  t.unevenness = measureUnevenness(mesh);
  t.sag = measureSag(mesh);
  t.volume = measureVolume(mesh.vertices, mesh.faces);
  if (springs != Springs::equal) t.springWeights = makeSpringWeights(mesh, t.edges);
  for (int e = 0; e < c.edgeCount; ++e)
    t.restSquares += (springs == Springs::equal ? 1 : t.springWeights[e]) * t.restLengths[e] * t.restLengths[e];
  if (springs == Springs::equal) return t;
  std::vector<double> sums(mesh.vertices.size());
  for (std::size_t end = 0; end < t.edges.size(); ++end) sums[t.edges[end]] += t.springWeights[end / 2];
  t.ringWeight = *std::ranges::max_element(sums);
  return t;
}

std::vector<double> makeSpringWeights(const Mesh& mesh, const std::vector<std::int32_t>& edges) {
  std::map<std::pair<std::int32_t, std::int32_t>, double> weights;
  for (const Face& face : mesh.faces)
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      const Point& opposite = mesh.vertices[face[(k + 2) % 3]];
      const Vector u = mesh.vertices[a] - opposite, v = mesh.vertices[b] - opposite;
      weights[{std::min(a, b), std::max(a, b)}] += 0.5 * std::sqrt(3.0) * dot(u, v) / norm(cross(u, v));
    }
  std::vector<double> ofEdges;
  for (std::size_t e = 0; e < edges.size(); e += 2)
    ofEdges.push_back(std::max(weights.at({edges[e], edges[e + 1]}), 0.05));
  return ofEdges;
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
