#include "division/halves.h"

#include "division/unfold.h"

namespace morula {

Halves halve(Points vertices, Faces faces, const Point& onPlane, const Vector& normal) {
  Halves h{{vertices.begin(), vertices.end()}, {vertices.begin(), vertices.end()}, 0, 0};
  std::vector<char> flatInA(vertices.size()), flatInB(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const double height = dot(vertices[v] - onPlane, normal);
    (height > 0 ? h.b : h.a)[v] = vertices[v] - height * normal;  // in whom it lies beyond the plane
    (height > 0 ? flatInB : flatInA)[v] = true;
  }
  unfold(h.a, faces, flatInA, -normal);
  unfold(h.b, faces, flatInB, normal);
  h.volumeA = measureVolume(h.a, faces), h.volumeB = measureVolume(h.b, faces);
  return h;
}

}  // namespace morula
