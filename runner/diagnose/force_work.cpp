#include "diagnose/force_work.h"

#include <algorithm>

#include "connections/connections.h"
#include "contacts/contacts.h"

namespace morula {

namespace {

/// [force] Of the membrane's springs [Nilsson 2008, eq. 4.2].
std::vector<Vector> springForces(const Bodies& b, int slot) {
  std::vector<Vector> force(b.vertexCount(slot));
  const Mesh& rest = b.meshOf(slot).mesh;
  const MembraneParameters& m = b.parameters.membrane;
  for (const Face& face : rest.faces)
    for (int k = 0; k < 3; ++k) {
      const int i = face[k], j = face[(k + 1) % 3];
      if (i > j) continue;  // every edge once: in one of its two faces it runs upwards
      const Vector d = b.vertex(slot, j) - b.vertex(slot, i);
      const double length = norm(d);
      if (!(length > 0)) continue;
      const Vector rate = b.read(b.velocity, slot, j) - b.read(b.velocity, slot, i);
      const double tension =
          m.stiffness * (length - b.restScale[slot] * norm(rest.vertices[i] - rest.vertices[j])) +
          m.damping * (dot(rate, d) / length);
      const Vector f = (tension / length) * d;
      force[i] = force[i] + f;
      force[j] = force[j] - f;
    }
  return force;
}

/// [length²] ∇V of each vertex: a third of the area vectors of its faces [Nilsson 2008, eq. 4.5].
std::vector<Vector> volumeGradients(const Bodies& b, int slot) {
  std::vector<Vector> gradient(b.vertexCount(slot));
  for (const auto& [i, j, k] : b.meshOf(slot).mesh.faces) {
    const Point x = b.vertex(slot, i);
    const Vector third = (1.0 / 6) * cross(b.vertex(slot, j) - x, b.vertex(slot, k) - x);
    for (const int v : {i, j, k}) gradient[v] = gradient[v] + third;
  }
  return gradient;
}

std::vector<Vector> scaled(double by, std::vector<Vector> vectors) {
  for (Vector& v : vectors) v = by * v;
  return vectors;
}

/// What `add` adds to the forces on the slot's vertices; the bodies are as before afterwards.
template <class Add>
std::vector<Vector> addedForces(Bodies& b, int slot, Add add) {
  const Reals kept = b.acceleration;
  b.acceleration.assign(b.acceleration.size(), 0);
  add();
  std::vector<Vector> force;
  for (int v = 0; v < b.vertexCount(slot); ++v) force.push_back(b.read(b.acceleration, slot, v));
  b.acceleration = kept;
  return force;
}

}  // namespace

WorkMeter::WorkMeter(World& world, const CellPath& cell)
    : cell_(cell), before_(positions(world)), forces_(measure(world)) {
  for (const Forces& f : forces_) works_.push_back({f.name, 0});
}

int WorkMeter::slotIn(const World& world) const {
  const auto& paths = world.cells.path;
  return world.bodies->slots[std::lower_bound(paths.begin(), paths.end(), cell_) - paths.begin()];
}

std::vector<Point> WorkMeter::positions(const World& world) const {
  const int slot = slotIn(world);
  std::vector<Point> points;
  for (int v = 0; v < world.bodies->vertexCount(slot); ++v) points.push_back(world.bodies->vertex(slot, v));
  return points;
}

std::vector<WorkMeter::Forces> WorkMeter::measure(World& world) const {
  Bodies& b = *world.bodies;
  const int slot = slotIn(world);
  std::vector<Forces> all;
  if (b.model().hasMembrane) {
    const std::vector<Vector> gradient = volumeGradients(b, slot);
    all.push_back({"springs", springForces(b, slot)});
    all.push_back({"contents", scaled(b.pressureConstant[slot] / b.volume[slot], gradient)});
    all.push_back({"outer pressure", scaled(-b.parameters.pressure.outside, gradient)});
  }
  if (world.contacts)
    all.push_back({"contacts", addedForces(b, slot, [&] {
                     addContactForces(*world.contacts, b, slot / blockLanes, world.clock.timeStep);
                   })});
  if (world.connections)
    all.push_back({"connections", addedForces(b, slot, [&] {
                     addConnectionForces(*world.connections, world.cells.path, b);
                   })});
  if (world.motility) all.push_back({"crawling", addedForces(b, slot, [&] { addMotility(world); })});
  if (b.model().hasRestShape) {
    Forces shape{"its shape", {}};  // what is left of the whole
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      Vector f = b.vertexMass[slot] * b.read(b.acceleration, slot, v);
      for (const Forces& other : all) f = f - other.onVertex[v];
      shape.onVertex.push_back(f);
    }
    all.push_back(std::move(shape));
  }
  return all;
}

void WorkMeter::observe(World& world) {
  const std::vector<Point> now = positions(world);
  std::vector<Forces> forces = measure(world);
  for (std::size_t f = 0; f < forces.size(); ++f)
    for (std::size_t v = 0; v < now.size(); ++v)
      works_[f].work += 0.5 * dot(forces_[f].onVertex[v] + forces[f].onVertex[v], now[v] - before_[v]);
  before_ = now;
  forces_ = std::move(forces);
}

std::vector<ForceWork> WorkMeter::works() const {
  std::vector<ForceWork> sorted = works_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ForceWork& a, const ForceWork& b) { return a.work > b.work; });
  return sorted;
}

}  // namespace morula
