#pragma once
// Cells that touch, without a world: moved by hand, one evaluation at a time.
#include "contacts/contacts.h"
#include "unit/physics/lab.h"

namespace morula {

/// The mesh of most cells of these tests.
inline const Mesh ball = makeIcosphere(1);

struct Crowd {
  Lab lab;
  Contacts contacts;

  Crowd(const PhysicsParameters& p, const ContactParameters& c, const Mesh& mesh, const std::vector<Body>& cells,
        Isa isa = Isa::scalar)
      : lab(p, mesh, cells, isa), contacts(makeContacts(c, isa, {}, p.precision)) {
    resetContacts(contacts, lab.bodies);
    step(0);
  }

  void step(double timeStep) {
    advanceAndSnapshot(timeStep, timeStep);
    addForces();
    lab.endEvaluation(timeStep);
  }

  /// Evaluates the forces of contact and bodies; lab.force(slot, v) reads them.
  void evaluateForces() {
    advanceAndSnapshot(0, 0);
    addForces();
  }

  /// Evaluates the forces of contact alone. `sinceLast`: see takeSnapshot.
  void evaluateContacts(double sinceLast = 0) {
    advanceAndSnapshot(0, sinceLast);
    lab.bodies.acceleration.assign(lab.bodies.acceleration.size(), 0);
    addForces();
  }

  void addForces() {
    refreshList(contacts, lab.bodies, 1);
    for (int i = 0; i < lab.bodies.blockCount(); ++i) addContactForces(contacts, lab.bodies, i, lawTimeStep);
  }

  void advanceAndSnapshot(double timeStep, double sinceLast) {
    Bodies& b = lab.bodies;
    for (int i = 0; i < b.blockCount(); ++i) {
      advance(lab.stages, b, b.block(i, 0), timeStep);
      takeSnapshot(contacts, b, b.block(i, 0), i, sinceLast);
    }
  }

  int slotOf(VertexNumber g) const {
    const Bodies& b = lab.bodies;
    int block = 0;
    while (block + 1 < b.blockCount() && b.blocks[block + 1].firstLine <= g / blockLanes) ++block;
    return block * blockLanes + g % blockLanes;
  }

  double lawTimeStep = 0x1p-9;  // the time step that the thesis' law and viscosity use
};

/// Returns the indices of each block as kernels read them. [block]
inline std::vector<AlignedVector<std::int32_t>> indicesOf(const NeighbourList& list) {
  std::vector<AlignedVector<std::int32_t>> all;
  for (const BlockLists& lists : list.perBlock) all.push_back(lists.indices);
  return all;
}

/// Returns the crowd with forces of contact and bodies evaluated at its present positions.
inline Crowd evaluated(Crowd crowd) {
  crowd.evaluateForces();
  return crowd;
}

/// Returns mechanics of contact alone: a mesh without stiffness and gas.
inline PhysicsParameters limp() {
  PhysicsParameters p = softCell();
  p.membrane = {0, 0, 1};
  p.pressure = {0, 0};
  return p;
}

/// Returns crumpled balls of different sizes, in motion, piled up in cubes of 3 × 3 × 3 with centres `spacing` apart.
/// Below a spacing of 2 they touch.
inline std::vector<Body> heap(const Mesh& ball, int count, double spacing, double speed, std::uint32_t key = 0) {
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

/// Returns a body of the mesh at rest, turned at random, with the given size and place.
inline Body turnedBody(const Mesh& mesh, std::uint32_t key, double size = 1, const Vector& place = {}) {
  const Vector q = noiseVector(7, key);  // vector part of a quaternion with scalar part ½
  const double w = 0.5, square = w * w + dot(q, q);
  Body b = shakenBody(mesh, 0, 0);
  b.restScale = size, b.mass = size * size * size;
  for (Point& x : b.position)
    x = size / square * ((w * w - dot(q, q)) * x + 2 * dot(q, x) * q + 2 * w * cross(q, x)) + place;
  return b;
}

/// Returns the mesh's mean edge, from the mesh alone. [length]
inline double meanEdge(const Mesh& mesh) {
  double sum = 0;
  for (const Face& f : mesh.faces)  // counts each edge twice
    for (int k = 0; k < 3; ++k) sum += norm(mesh.vertices[f[k]] - mesh.vertices[f[(k + 1) % 3]]);
  return sum / (3.0 * static_cast<double>(mesh.faces.size()));
}

/// A vertex as the laws see it, from the mesh alone: its position for other cells and its normal.
struct SeenVertex {
  int slot, v;
  Point x;
  Vector velocity, normal;
  double inverseRadiusSquared;
};

/// Position and normal of a vertex for other cells, by the equations of surface_kernel.h.
struct SeenSurface {
  Point y;
  Vector n;
};

/// The faces and the vertices around each vertex.
struct Rings {
  std::vector<std::vector<Face>> faces;      // [vertex] faces turned so that the vertex comes first
  std::vector<std::vector<int>> neighbours;  // [vertex]

  explicit Rings(const Mesh& mesh) : faces(mesh.vertices.size()), neighbours(mesh.vertices.size()) {
    for (const auto& [i, j, k] : mesh.faces) {
      faces[i].push_back({i, j, k}), faces[j].push_back({j, k, i}), faces[k].push_back({k, i, j});
      neighbours[i].push_back(j), neighbours[j].push_back(k), neighbours[k].push_back(i);
    }
  }

  SeenSurface see(const std::vector<Point>& x, int v, double inverseRadiusSquared, double sag) const {
    Vector g, around;
    for (const auto& [i, j, k] : faces[v]) g += cross(x[j] - x[i], x[k] - x[i]);
    const double fold = 2 / inverseRadiusSquared, scale = std::sqrt(1 + 4.0 / 27);
    for (int k : neighbours[v]) around += x[k];
    const Vector n = scale / std::sqrt(dot(g, g) + fold * fold) * g;
    return {x[v] + (around / static_cast<double>(neighbours[v].size()) - x[v]) / 8.0 - 0.65 * sag * n, n};
  }
};

/// Returns all vertices as the law sees them; the thesis' law sees the mesh's vertices with unit normals.
inline std::vector<SeenVertex> seen(const Bodies& b, const ContactParameters& c) {
  std::vector<SeenVertex> all;
  const Rings rings(b.mesh.mesh);
  const auto asFloat = [](double a) -> double { return static_cast<float>(a); };  // rows hold floats
  for (int slot = 0; slot < b.count; ++slot) {
    const Body body = takeBody(b, slot);
    const double radius = c.radius * meanEdge(b.mesh.mesh) * body.restScale;
    const double inverseRadiusSquared = asFloat(1 / (radius * radius));
    for (int v = 0; v < b.vertexCount(); ++v) {
      const Vector u = body.velocity[v];
      SeenSurface s = rings.see(body.position, v, inverseRadiusSquared, b.sag[slot]);
      if (c.law == ContactLaw::thesis) s = {body.position[v], s.n / norm(s.n)};
      all.push_back({slot, v, s.y, {asFloat(u.x), asFloat(u.y), asFloat(u.z)}, s.n, inverseRadiusSquared});
    }
  }
  return all;
}

}  // namespace morula
