#include "mesh/mesh_measures.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/maths.h"

namespace morula {

// F(x) = x has divergence 3, so 3 V = Σ_faces ∫ x · n dA = Σ_faces (v1 + v2 + v3)/3 · n A, with n A = (v2 − v1) × (v3 −
// v1)/2. Each term of v1 + v2 + v3 gives the same triple product, together 3 v1 · (v2 × v3). The factors 3 cancel, and
// 1/2 · 1/3 leave the 6. Positions are taken from the first vertex, so that a cell far from the origin loses no digits.
double measureVolume(Points vertices, Faces faces) {
  if (vertices.empty()) return 0;
  const Point origin = vertices[0];
  double sum = 0;
  for (const auto& [a, b, c] : faces)
    sum += dot(vertices[a] - origin, cross(vertices[b] - origin, vertices[c] - origin));
  return sum / 6;
}

namespace {

Mesh scaleBy(Mesh mesh, double factor) {
  for (Point& x : mesh.vertices) x *= factor;
  return mesh;
}

}  // namespace

Mesh scaleToVolume(Mesh mesh, double volume) {
  const double own = measureVolume(mesh.vertices, mesh.faces);
  return scaleBy(std::move(mesh), cubeRoot(volume / own));
}

// The radius is not cubed: its cube may underflow or overflow.
Mesh scaleToRadius(Mesh mesh, double radius) {
  const double own = measureVolume(mesh.vertices, mesh.faces);
  return scaleBy(std::move(mesh), radius * cubeRoot(4 * std::numbers::pi / 3 / own));
}

double measureArea(Points vertices, Faces faces) {
  double sum = 0;
  for (const auto& [a, b, c] : faces) sum += norm(cross(vertices[b] - vertices[a], vertices[c] - vertices[a]));
  return sum / 2;
}

Point measureCentroid(Points vertices) {
  MORULA_CHECK(!vertices.empty(), "a mesh without vertices has no centroid");
  Vector sum;
  for (const Point& v : vertices) sum += v;
  return sum / static_cast<double>(vertices.size());
}

// The tetrahedron of the origin and a face (a, b, c) has 6 V = a · (b × c), ∫ x = V (a + b + c)/4 and ∫ |x|² = V (|a|²
// + |b|² + |c|² + |a + b + c|²)/20. With the sign of V they add up over a closed surface.
SolidMoments measureMoments(Points vertices, Faces faces) {
  const Point origin = measureCentroid(vertices);
  SolidMoments m;
  Vector first;
  for (const auto& [i, j, k] : faces) {
    const Vector a = vertices[i] - origin, b = vertices[j] - origin, c = vertices[k] - origin, sum = a + b + c;
    const double volume = dot(a, cross(b, c)) / 6;
    m.volume += volume;
    first += volume / 4 * sum;
    m.second += volume / 20 * (dot(a, a) + dot(b, b) + dot(c, c) + dot(sum, sum));
  }
  const Vector mean = first / m.volume;
  m.centre = origin + mean;
  m.second -= m.volume * dot(mean, mean);
  return m;
}

double sphericity(double volume, double area) {
  if (!(volume >= std::numeric_limits<double>::min() && area > 0)) return 0;
  const double root = cubeRoot(6 * volume);
  return cubeRoot(std::numbers::pi) * root * root / area;
}

Box measureBox(Points vertices) {
  MORULA_CHECK(!vertices.empty(), "no box holds nothing");
  Box box{vertices[0], vertices[0]};
  for (const Point& v : vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  return box;
}

}  // namespace morula
