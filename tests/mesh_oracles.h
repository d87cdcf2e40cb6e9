#pragma once
// Measures of meshes that only tests need.
#include "mesh/mesh_measures.h"
#include "mesh/scan_line.h"

namespace morula {

/// Returns the number of faces whose inner side is turned away from `centre`. The number is 0 for a mesh that is
/// star-shaped about `centre`, as convex meshes are about any inner point. A convex cell with many such faces is
/// turning inside out.
inline int countFacesTurnedInward(Points vertices, Faces faces, const Point& centre) {
  int count = 0;
  for (const auto& [a, b, c] : faces) {
    const Vector normal = cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
    if (!(dot(normal, vertices[a] - centre) > 0)) ++count;
  }
  return count;
}

/// Returns true if the closed mesh winds around the point, by the crossings of the half line upwards (+z) from it. A
/// point on the surface counts as inside or outside consistently: exactly one of meshes that tile space has it.
inline bool isInside(const Point& point, Points vertices, Faces faces) {
  int winding = 0;
  Slice s;
  for (const auto& [a, b, c] : faces)
    if (slice(vertices[a], vertices[b], vertices[c], point.y, s) && s.meets(point.x) && s.heightAt(point.x) > point.z)
      winding += s.sign;
  return winding > 0;
}

}  // namespace morula
