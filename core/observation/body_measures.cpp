
#include "observation/body_measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/maths.h"
#include "contacts/contact_surface.h"
#include "mesh/mesh_measures.h"
#include "mesh/overlap.h"
#include "physics/shell_surface.h"

namespace morula {
namespace {

constexpr double ballArea = 4 * std::numbers::pi;  // over the square of the radius

}  // namespace

BodyShape measureShape(const Bodies& b, int slot) {
  Mesh surface = takeSurface(b, slot);
  if (b.areSpheres()) {
    const double radius = b.parameters.cell.radius * b.restScale[slot];
    return {std::move(surface), b.vertex(slot, 0), b.volume[slot], ballArea * radius * radius, {}, true};
  }
  const auto& [vertices, faces] = surface;
  BodyShape shape{
      {},         measureCentroid(vertices), measureVolume(vertices, faces), measureArea(vertices, faces), {}, false,
      b.sag[slot]};
  if (b.model().hasMembrane) shape.pressure = b.pressureConstant[slot] / shape.volume - b.parameters.pressure.outside;
  shape.surface = std::move(surface);
  return shape;
}

double measureMeshVolume(const Bodies& b, int meshLevel) {
  const double r = b.parameters.cell.radius;
  const Mesh& mesh = b.meshAt(meshLevel).mesh;
  return b.areSpheres() ? ballArea / 3 * (r * r * r) : measureVolume(mesh.vertices, mesh.faces);
}

double measureRestVolume(const Bodies& b, int slot, double meshVolume) {
  const double ofEgg = b.parameters.pressure.constant, scale = b.restScale[slot];
  if (b.model().hasMembrane && ofEgg > 0) return meshVolume * (b.pressureConstant[slot] / ofEgg);
  return meshVolume * scale * scale * scale;
}

double measureRestVolume(const Bodies& b, int slot) {
  return measureRestVolume(b, slot, measureMeshVolume(b, b.blocks[slot / blockLanes].meshLevel));
}

SolidMoments measureMoments(const Bodies& b, int slot) {
  const Mesh surface = takeSurface(b, slot);
  if (!b.areSpheres()) return measureMoments(surface.vertices, surface.faces);
  const double radius = b.parameters.cell.radius * b.restScale[slot], volume = b.volume[slot];
  return {volume, b.vertex(slot, 0), 0.6 * volume * radius * radius};
}

double measureKineticEnergy(const Bodies& b, int slot) {
  double sum = 0;
  for (int v = 0; v < b.vertexCount(slot); ++v) {
    const Vector u = b.read(b.velocity, slot, v);
    sum += dot(u, u);
  }
  return 0.5 * b.vertexMass[slot] * sum;
}

Vector measureMeanVelocity(const Bodies& b, int slot) {
  Vector sum;
  for (int v = 0; v < b.vertexCount(slot); ++v) sum += b.read(b.velocity, slot, v);
  return sum / b.vertexCount(slot);
}

Vector measureMomentum(const Bodies& b) {
  Vector sum;
  for (int slot : b.slots)
    for (int v = 0; v < b.vertexCount(slot); ++v) sum += b.vertexMass[slot] * b.read(b.velocity, slot, v);
  return sum;
}

namespace {

/// A ball touches a plane that is its radius farther out than its centre.
double measureOutermostInPlanes(const Bodies& b, int slot) {
  const double radius = b.areSpheres() ? b.parameters.cell.radius * b.restScale[slot] : 0;
  double outermost = 0;
  for (int v = 0; v < b.vertexCount(slot); ++v)
    for (const ShellPlane& plane : b.parameters.shell->mesh->planes)
      outermost = std::max(outermost, (dot(plane.normal, b.vertex(slot, v)) + radius) / plane.offset);
  return outermost;
}

}  // namespace

double measureOutermost(const Bodies& b, int slot) {
  if (b.parameters.shell->mesh) return measureOutermostInPlanes(b, slot);
  const double* a = b.parameters.shell->semiAxes.data();
  const double radius = b.parameters.cell.radius * b.restScale[slot];
  if (b.areSpheres() && a[0] == a[1] && a[1] == a[2]) return (norm(b.vertex(slot, 0)) + radius) / a[0];
  double outermost = 0;
  for (Point p : takeSurface(b, slot).vertices) {
    if (!b.areSpheres()) {
      p = heldPoint(p, *b.parameters.shell, b.sag[slot]);
    } else {  // in the same direction, on the ball
      const Point centre = b.vertex(slot, 0);
      const Vector way = p - centre;
      p = centre + (radius / norm(way)) * way;
    }
    const Vector q{p.x / a[0], p.y / a[1], p.z / a[2]};
    outermost = std::max(outermost, dot(q, q));
  }
  return std::sqrt(outermost);
}

double measureExtent(const Bodies& b) {
  double extent = 0;
  const bool holds = b.parameters.shell && !b.areSpheres();
  for (int slot : b.slots) {
    const double around = b.areSpheres() ? b.parameters.cell.radius * b.restScale[slot] : 0;
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      const Point x = b.vertex(slot, v);
      const double here = norm(holds ? heldPoint(x, *b.parameters.shell, b.sag[slot]) : x) + around;
      if (std::isnan(here)) return here;  // std::max would pass over it
      extent = std::max(extent, here);
    }
  }
  return extent;
}

double measureInvertedShare(const BodyShape& shape) {
  const Point centre = measureCentroid(shape.surface.vertices);
  double all = 0, inverted = 0;
  for (const auto& [a, b, c] : shape.surface.faces) {
    const Point& corner = shape.surface.vertices[a];
    const Vector normal = cross(shape.surface.vertices[b] - corner, shape.surface.vertices[c] - corner);
    const double size = norm(normal);
    all += size;
    if (dot(normal, corner - centre) < 0) inverted += size;
  }
  return all > 0 ? inverted / all : 1;
}

double measureShellShare(const BodyShape& shape, const ShellParameters& shell) {
  constexpr double within = 1e-6;  // the shell puts points onto itself to rounding, of single precision too
  if (shape.isBall) return 0;
  const double* a = shell.semiAxes.data();
  const std::vector<Point>& vertices = shape.surface.vertices;
  const std::vector<Face>& faces = shape.surface.faces;
  const auto isOnShell = [&](int v) {
    if (shell.mesh) return measureReach(shell.mesh->planes, vertices[v]) > 1 - within;
    const Point held = heldPoint(vertices[v], shell, shape.sag);
    const Vector q{held.x / a[0], held.y / a[1], held.z / a[2]};
    return std::sqrt(dot(q, q)) > 1 - within;
  };
  double all = 0, onShell = 0;
  for (const Face& face : faces) {
    const Point& corner = vertices[face[0]];
    const double twice = norm(cross(vertices[face[1]] - corner, vertices[face[2]] - corner));
    all += twice;
    for (int v : face)
      if (isOnShell(v)) onShell += twice / 3;
  }
  return all > 0 ? onShell / all : 0;
}

ShellPlace measurePlaceInShell(const ShellParameters& shell, const Point& place) {
  const double* a = shell.semiAxes.data();
  if (!shell.mesh) {
    const Vector along{place.x / a[0], place.y / a[1], place.z / a[2]};
    return {along, norm(along)};
  }
  const auto [low, high] = measureBox(shell.mesh->mesh.vertices);
  const auto over = [](double x, double least, double most) { return x / (x < 0 ? -least : most); };
  return {{over(place.x, low.x, high.x), over(place.y, low.y, high.y), over(place.z, low.z, high.z)},
          measureReach(shell.mesh->planes, place)};
}

double measureMeanOverlap(const Bodies& b, const Contacts* contacts, int columns) {
  if (b.count == 0) return 0;
  std::vector<Mesh> surfaces;
  for (int slot : b.slots) surfaces.push_back(takeContactSurface(contacts, b, slot));
  std::vector<MeshView> meshes;
  for (const Mesh& surface : surfaces) meshes.push_back({surface.vertices, surface.faces});
  return measureOverlap(meshes, columns).meanShare();
}

}  // namespace morula
