#include "simulation/measures.h"

#include <algorithm>
#include <cmath>

#include "mesh/measures.h"
#include "mesh/overlap.h"
#include "simulation/world.h"

namespace morula {

namespace {

CellMeasures measureMesh(const Bodies& b, int slot) {
  const auto& [vertices, faces] = takeSurface(b, slot);
  CellMeasures m;
  m.volume = measureVolume(vertices, faces);
  m.area = measureArea(vertices, faces);
  if (b.parameters.cell.model == CellModel::shell)
    m.pressure = b.pressureConstant[slot] / m.volume - b.parameters.pressure.outside;
  m.centroid = measureCentroid(vertices);
  m.sphericity = sphericity(m.volume, m.area);
  return m;
}

CellMeasures measureSphere(const Bodies& b, int slot) {
  const double radius = b.parameters.cell.radius * b.restScale[slot];
  CellMeasures m;
  m.volume = b.volume[slot];
  m.area = 12.566370614359172 * radius * radius;
  m.centroid = b.vertex(slot, 0);
  m.sphericity = 1;
  return m;
}

}  // namespace

double measureKineticEnergy(const Bodies& b, int slot) {
  double sum = 0;
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    const Vector u = b.read(b.velocity, slot, v);
    sum += dot(u, u);
  }
  return 0.5 * b.vertexMass[slot] * sum;
}

double measureOutermost(const Bodies& b, int slot) {
  const double* a = b.parameters.shell->semiAxes;
  const double radius = b.parameters.cell.radius * b.restScale[slot];
  if (b.areSpheres() && a[0] == a[1] && a[1] == a[2]) return (norm(b.vertex(slot, 0)) + radius) / a[0];
  double outermost = 0;
  for (Point p : takeSurface(b, slot).vertices) {
    if (b.areSpheres()) {  // in the same direction, on the ball
      const Point centre = b.vertex(slot, 0);
      const Vector way = p - centre;
      p = centre + (radius / norm(way)) * way;
    }
    const Vector q{p.x / a[0], p.y / a[1], p.z / a[2]};
    outermost = std::max(outermost, dot(q, q));
  }
  return std::sqrt(outermost);
}

WorldMeasures measureWorld(const World& world) {
  WorldMeasures m;
  m.time = world.clock.time;
  m.step = world.clock.step;
  m.cells = world.cells.path.size();
  if (!world.bodies) return m;
  const Bodies& b = *world.bodies;
  double volume = 0, pressure = 0, kineticEnergy = 0;
  for (int slot : b.slots) {
    volume += b.volume[slot];
    pressure += b.pressure[slot];
    kineticEnergy += measureKineticEnergy(b, slot);
  }
  m.volume = volume;
  m.kineticEnergy = kineticEnergy;
  if (b.count > 0) m.meanPressure = pressure / b.count;
  if (b.parameters.shell) {
    const double* a = b.parameters.shell->semiAxes;
    m.shellFill = volume / (12.566370614359172 / 3 * a[0] * a[1] * a[2]);
    for (int slot : b.slots) m.outermost = std::max(m.outermost.value_or(0), measureOutermost(b, slot));
  }
  return m;
}

std::vector<CellMeasures> measureCells(const World& world) {
  std::vector<CellMeasures> all;
  if (!world.bodies) return all;
  const Bodies& b = *world.bodies;
  for (int cell = 0; cell < b.count; ++cell) {
    const int slot = b.slots[cell];
    CellMeasures m = b.areSpheres() ? measureSphere(b, slot) : measureMesh(b, slot);
    m.path = world.cells.path[cell];
    m.state = world.cells.state[cell];
    all.push_back(m);
  }
  if (world.contacts)
    for (const ContactArea& touch : measureContactAreas(*world.contacts, b)) {
      ++all[touch.a].neighbours;
      ++all[touch.b].neighbours;
    }
  return all;
}

std::vector<ContactMeasures> measureContacts(const World& world) {
  std::vector<ContactMeasures> all;
  if (!world.contacts) return all;
  for (const ContactArea& touch : measureContactAreas(*world.contacts, *world.bodies))
    all.push_back({world.cells.path[touch.a], world.cells.path[touch.b], touch.area});
  return all;
}

double measureMeanOverlap(const World& world, int columns) {
  if (!world.bodies || world.bodies->count == 0) return 0;
  const Bodies& b = *world.bodies;
  std::vector<Mesh> surfaces;
  for (int slot : b.slots) surfaces.push_back(takeSurface(b, slot));
  std::vector<MeshView> meshes;
  for (const Mesh& surface : surfaces) meshes.push_back({surface.vertices, surface.faces});
  return measureOverlap(meshes, columns).meanShare();
}

Mesh cellMesh(const World& world, const CellPath& path) {
  if (!world.bodies) return {};
  const auto& paths = world.cells.path;
  const auto at = std::lower_bound(paths.begin(), paths.end(), path);
  if (at == paths.end() || *at != path) return {};
  return takeSurface(*world.bodies, world.bodies->slots[at - paths.begin()]);
}

std::vector<Point> cellVertices(const World& world, const CellPath& path) {
  return cellMesh(world, path).vertices;
}

}  // namespace morula
