#include "physics/bending.h"

#include <cmath>

namespace morula {
namespace {

/// Returns W x: the sums over the one-rings of w times the difference to the neighbour, for one number a vertex.
std::vector<double> applyWeights(const MeshTemplate& mesh, const Bending& bending, const std::vector<double>& x) {
  std::vector<double> sums(x.size());
  for (std::size_t v = 0; v < x.size(); ++v)
    for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
      sums[v] += bending.weights[k] * (x[mesh.ring[k].vertexOffset / vertexStride] - x[v]);
  return sums;
}

/// Returns the largest eigenvalue [1/length²] of W A⁻¹ W by power iteration. It comes from below: after so many rounds
/// icospheres and meshes of modellers lack less than a percent, which the room covers.
double measureStiffest(const MeshTemplate& mesh, const Bending& bending) {
  constexpr int rounds = 200;
  constexpr double room = 1.01;
  std::vector<double> x(mesh.mesh.vertices.size());
  for (std::size_t v = 0; v < x.size(); ++v) x[v] = (v * 7919 % 101) / 101.0 - 0.5;  // no mode lacks a share
  double largest = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<double> y = applyWeights(mesh, bending, x);
    for (std::size_t v = 0; v < y.size(); ++v) y[v] *= bending.inverseAreas[v];
    y = applyWeights(mesh, bending, y);
    double square = 0;
    for (const double a : y) square += a * a;
    largest = std::sqrt(square);
    for (std::size_t v = 0; v < y.size(); ++v) x[v] = y[v] / largest;
  }
  return room * largest;
}

/// Returns κ [force·length] over the cell's scale²; 0 without bending.
double scaledRigidity(const Bodies& b, int slot) {
  return b.model().hasMembrane ? b.parameters.membrane.bending / (b.restScale[slot] * b.restScale[slot]) : 0;
}

/// Returns L of each vertex [length].
std::vector<Vector> measureCurvatures(const Bodies& b, int slot) {
  const MeshTemplate& mesh = b.meshOf(slot);
  std::vector<Vector> sums(b.vertexCount(slot));
  for (int v = 0; v < b.vertexCount(slot); ++v)
    for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
      sums[v] +=
          mesh.bending.weights[k] * (b.vertex(slot, mesh.ring[k].vertexOffset / vertexStride) - b.vertex(slot, v));
  return sums;
}

}  // namespace

double measureBendingEnergy(const Bodies& b, int slot) {
  const double rigidity = scaledRigidity(b, slot);
  if (!(rigidity > 0)) return 0;
  const std::vector<Vector> curvature = measureCurvatures(b, slot);
  double sum = 0;
  for (std::size_t v = 0; v < curvature.size(); ++v)
    sum += dot(curvature[v], curvature[v]) * b.meshOf(slot).bending.inverseAreas[v];
  return 0.5 * rigidity * sum;
}

std::vector<Vector> measureBendingForces(const Bodies& b, int slot) {
  const double rigidity = scaledRigidity(b, slot);
  std::vector<Vector> force(b.vertexCount(slot));
  if (!(rigidity > 0)) return force;
  const MeshTemplate& mesh = b.meshOf(slot);
  std::vector<Vector> c = measureCurvatures(b, slot);
  for (std::size_t v = 0; v < c.size(); ++v) c[v] = mesh.bending.inverseAreas[v] * c[v];
  for (std::size_t v = 0; v < c.size(); ++v)
    for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
      force[v] += (rigidity * mesh.bending.weights[k]) * (c[v] - c[mesh.ring[k].vertexOffset / vertexStride]);
  return force;
}

Bending makeBending(const MeshTemplate& mesh) {
  Bending bending;
  const std::vector<double> weights = makeSpringWeights(mesh.mesh, mesh.edges);
  for (const RingStep& step : mesh.ring) {
    const int edge = step.edgeOffset / blockLanes;
    bending.weights.push_back(edge == mesh.edgeCount() ? 0 : weights[edge] / std::sqrt(3.0));
  }
  std::vector<double> areas(mesh.mesh.vertices.size());
  for (const auto& [i, j, k] : mesh.mesh.faces) {
    const Point& x = mesh.mesh.vertices[i];
    const double third = norm(cross(mesh.mesh.vertices[j] - x, mesh.mesh.vertices[k] - x)) / 6;
    for (const int v : {i, j, k}) areas[v] += third;
  }
  for (const double area : areas) bending.inverseAreas.push_back(1 / area);
  bending.stiffest = measureStiffest(mesh, bending);
  return bending;
}

}  // namespace morula
