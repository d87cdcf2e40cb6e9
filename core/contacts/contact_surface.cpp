#include "contacts/contact_surface.h"

#include <cmath>

namespace morula {

Mesh takeContactSurface(const Contacts* contacts, const Bodies& b, int slot) {
  Mesh surface = takeSurface(b, slot);
  if (!contacts || contacts->parameters.law != ContactLaw::pair || b.areSpheres()) return surface;
  std::vector<Vector> gradient(surface.vertices.size()), around(gradient);  // G = 6∇V; sum of the ring
  std::vector<double> neighbours(gradient.size());
  const Point origin = surface.vertices[0];
  for (const Face& face : surface.faces)
    for (int k = 0; k < 3; ++k) {  // the two faces at an edge run along it in opposite directions
      const Point &next = surface.vertices[face[(k + 1) % 3]], &last = surface.vertices[face[(k + 2) % 3]];
      gradient[face[k]] += cross(next - origin, last - origin);
      around[face[k]] += next;
      neighbours[face[k]] += 1;
    }
  const double radius = contacts->radius[slot], fold = foldedNormal * radius * radius;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const Vector& g = gradient[v];
    const double depth = surfaceDepth * b.sag[slot] * std::sqrt(normalScaleSquared / (dot(g, g) + fold * fold));
    surface.vertices[v] += retreat * (around[v] / neighbours[v] - surface.vertices[v]) - depth * g;
  }
  return surface;
}

}  // namespace morula
