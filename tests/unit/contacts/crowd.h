#pragma once
// Cells that touch, without world: moved by hand, one evaluation at a time.
#include <optional>

#include "contacts/contacts.h"
#include "unit/physics/lab.h"

namespace morula {

struct Crowd {
  Lab lab;
  Contacts contacts;

  Crowd(const PhysicsParameters& p, const ContactParameters& c, const Mesh& mesh,
        const std::vector<Body>& cells, Isa isa = Isa::scalar)
      : lab(p, mesh, cells, isa), contacts(makeContacts(c, isa)) {
    resetContacts(contacts, lab.bodies);
    step(0);
  }

  void step(double timeStep) {
    Bodies& b = lab.bodies;
    advanceAndSnapshot(timeStep);
    refreshList(contacts, b, 1);
    for (int i = 0; i < b.blockCount(); ++i) addContactForces(contacts, b, i, lawTimeStep);
    lab.endEvaluation(timeStep);
  }

  /// Leaves the forces of contact and bodies in the accelerations' place: lab.force(slot, v).
  void evaluateForces() {
    Bodies& b = lab.bodies;
    advanceAndSnapshot(0);
    refreshList(contacts, b, 1);
    for (int i = 0; i < b.blockCount(); ++i) addContactForces(contacts, b, i, lawTimeStep);
  }

  void advanceAndSnapshot(double timeStep) {
    Bodies& b = lab.bodies;
    for (int i = 0; i < b.blockCount(); ++i) {
      advance(lab.stages, b, b.block(i, 0), timeStep);
      takeSnapshot(contacts, b, b.block(i, 0), i);
    }
  }

  double lawTimeStep = 0x1p-9;  // what the thesis' law is told
};

/// Mechanics of which only contact is left: a mesh without stiffness and gas.
inline PhysicsParameters limp() {
  PhysicsParameters p = softCell();
  p.membrane = {0, 0, 1};
  p.pressure = {0, 0};
  return p;
}

/// Crumpled balls of different sizes, in motion, piled up in cubes of 3 × 3 × 3 with their centres `spacing`
/// apart: they touch from 2 downwards.
inline std::vector<Body> heap(const Mesh& ball, int count, double spacing, double speed,
                              std::uint32_t key = 0) {
  std::vector<Body> cells;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t k = 100 * key + static_cast<std::uint32_t>(i);
    const double size = 1 + 0.1 * noise(0, k);
    Body b = shakenBody(ball, 0.02, speed, k);
    b.restScale = size;
    b.mass = size * size * size;
    const Vector place{double(i % 3), double(i / 3 % 3), double(i / 9)};
    for (Point& x : b.position) x = size * x + spacing * (place + 0.05 * noiseVector(1, k));
    cells.push_back(b);
  }
  return cells;
}

inline VertexNumber numberOf(const Bodies& b, int slot, int v) {
  return (slot / blockLanes * b.vertexCount() + v) * blockLanes + slot % blockLanes;
}

/// One vertex as the laws see it, worked out from the mesh alone.
struct SeenVertex {
  int slot, v;
  Point x;
  Vector velocity, normal;
  double inverseRadiusSquared;
};

inline std::vector<SeenVertex> seen(const Bodies& b, const ContactParameters& c) {
  std::vector<SeenVertex> all;
  double meanLength = 0;
  for (int e = 0; e < b.mesh.edgeCount(); ++e)
    meanLength +=
        norm(b.mesh.mesh.vertices[b.mesh.edges[2 * e]] - b.mesh.mesh.vertices[b.mesh.edges[2 * e + 1]]);
  meanLength /= b.mesh.edgeCount();
  for (int slot = 0; slot < b.count; ++slot) {
    const Body body = takeBody(b, slot);
    std::vector<Vector> normals(body.position.size());
    for (const auto& [i, j, k] : b.mesh.mesh.faces) {
      const Vector area = cross(body.position[j] - body.position[i], body.position[k] - body.position[i]);
      for (int v : {i, j, k}) normals[v] += area;
    }
    for (int v = 0; v < b.vertexCount(); ++v) {
      const Vector n = normals[v] / norm(normals[v]);
      const double radius = c.radius * meanLength * body.restScale;
      const float inverseRadiusSquared = static_cast<float>(1 / (radius * radius));
      const float nx = static_cast<float>(n.x), ny = static_cast<float>(n.y), nz = static_cast<float>(n.z);
      all.push_back({slot, v, body.position[v], body.velocity[v], {nx, ny, nz}, inverseRadiusSquared});
    }
  }
  return all;
}

}  // namespace morula
