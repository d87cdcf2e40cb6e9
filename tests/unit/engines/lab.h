#pragma once
// Scenes of one kind for Bullet: round, equal cells.

#include "engines/bullet_scene.h"
#include "mesh/mesh_measures.h"

namespace morula {

// Ends a test if the program was built without Bullet.
#define NEEDS_BULLET                               \
  if (!bulletIsAvailable()) {                      \
    WARN("this program was built without Bullet"); \
    return;                                        \
  }

/// Returns a scene of one cell without outside pressure: R0 = 1, M = 1, k_s = 10, k_p = 8.
inline BulletScene pressurisedCell(int level, Baseline baseline, double drag) {
  BulletScene scene;
  scene.baseline = baseline;
  scene.mesh = makeIcosphere(level);
  scene.physics.membrane = {10, 0, 1.26};
  scene.physics.pressure = {8, 0};
  scene.physics.drag = drag;
  scene.contact = false;
  scene.cells = {{scene.mesh.vertices, std::vector<Vector>(scene.mesh.vertices.size()), 1, 1, 8}};
  return scene;
}

inline double meanRadius(const Body& cell) {
  double sum = 0;
  for (const Point& x : cell.position) sum += norm(x);
  return sum / static_cast<double>(cell.position.size());
}

inline double volume(const BulletScene& scene, const Body& cell) {
  return measureVolume(cell.position, scene.mesh.faces);
}

/// Returns f = Δl, the law of the thesis' springs.
inline double linearLaw(double length, double rest) { return length - rest; }
/// Returns the effective law of Bullet's links [btSoftBody.cpp, PSolve_Links].
inline double bulletsLaw(double length, double rest) {
  return length * (length * length - rest * rest) / (length * length + rest * rest);
}

/// Steps one cell by x' = x + Δt v', v' = v + Δt a(x, v), with springs summed over edges and pressure over faces.
/// `law`: tension of a spring over its stiffness.
template <class Law>
void stepByHand(const BulletScene& scene, const MeshTemplate& mesh, Body& cell, const Law& law) {
  const double m = cell.mass / mesh.vertexCount(), ks = scene.physics.membrane.stiffness,
               kd = scene.physics.membrane.damping.constant;
  std::vector<Vector> force(cell.position.size());
  for (int e = 0; e < mesh.edgeCount(); ++e) {
    const int i = mesh.edges[2 * e], j = mesh.edges[2 * e + 1];
    const Vector d = cell.position[j] - cell.position[i];
    const double length = norm(d);
    const double opening = dot(cell.velocity[j] - cell.velocity[i], d) / length;
    const double weight = mesh.springWeights.empty() ? 1 : mesh.springWeights[e];
    const double tension = ks * law(length, mesh.restLengths[e] * cell.restScale) + kd * opening;
    const Vector f = (weight * tension / length) * d;
    force[i] += f;
    force[j] -= f;
  }
  const double pressure = cell.pressureConstant / volume(scene, cell) - scene.physics.pressure.outside;
  for (const Face& f : scene.mesh.faces) {
    const Point a = cell.position[f[0]], b = cell.position[f[1]], c = cell.position[f[2]];
    const Vector third = (pressure / 6) * cross(b - a, c - a);
    for (const auto v : f) force[v] += third;
  }
  for (std::size_t v = 0; v < force.size(); ++v) {
    cell.velocity[v] += scene.timeStep * (force[v] / m - scene.physics.drag * cell.velocity[v]);
    cell.position[v] += scene.timeStep * cell.velocity[v];
  }
}

}  // namespace morula
