#include "bench/ordinary_cell.h"

namespace morula {

OrdinaryCell makeOrdinaryCell(const MeshTemplate& mesh, const Body& body) {
  OrdinaryCell cell;
  for (std::size_t v = 0; v < body.position.size(); ++v)
    cell.vertices.push_back({body.position[v], body.velocity[v], {}, body.mass / mesh.vertexCount()});
  for (int e = 0; e < mesh.edgeCount(); ++e)
    cell.springs.push_back({mesh.edges[2 * e], mesh.edges[2 * e + 1], mesh.restLengths[e] * body.restScale,
                            mesh.springWeights.empty() ? 1 : mesh.springWeights[e]});
  cell.faces = mesh.mesh.faces;
  cell.pressureConstant = body.pressureConstant;
  return cell;
}

void findForces(OrdinaryCell& cell, const PhysicsParameters& p) {
  auto& vertices = cell.vertices;
  const double damping = p.membrane.damping.of(p.membrane.stiffness, vertices[0].mass);
  for (auto& v : vertices) v.force = (-p.drag * v.mass) * v.velocity;

  for (const auto& spring : cell.springs) {
    auto &a = vertices[spring.first], &b = vertices[spring.second];
    const Vector d = b.position - a.position;
    const double length = norm(d);
    const Vector direction = d / length;
    const double opening = dot(b.velocity - a.velocity, direction);
    const double tension = p.membrane.stiffness * (length - spring.restLength) + damping * opening;
    const Vector force = (spring.weight * tension) * direction;
    a.force += force;
    b.force -= force;
  }

  const Point origin = vertices[0].position;
  double sixVolumes = 0;
  for (const Face& f : cell.faces)
    sixVolumes += dot(vertices[f[0]].position - origin,
                      cross(vertices[f[1]].position - origin, vertices[f[2]].position - origin));
  cell.volume = sixVolumes / 6;
  cell.pressure = cell.pressureConstant / cell.volume - p.pressure.outside;

  for (const Face& f : cell.faces) {
    auto &a = vertices[f[0]], &b = vertices[f[1]], &c = vertices[f[2]];
    // P A/3 along the normal; the cross product is twice the area vector.
    const Vector third = (cell.pressure / 6) * cross(b.position - a.position, c.position - a.position);
    a.force += third;
    b.force += third;
    c.force += third;
  }
}

}  // namespace morula
