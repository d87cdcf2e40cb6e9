#pragma once
// Measures of meshes that only tests need.
#include "mesh/measures.h"
#include "mesh/scan_line.h"

namespace morula {

/// The number of faces whose inner side is not turned to `centre`: 0 for a mesh that is star-shaped about it,
/// as every convex one is about any point inside. A convex cell that comes to have many is turning inside out.
inline int countFacesTurnedInward(Points vertices, Faces faces, const Point& centre) {
  int count = 0;
  for (const auto& [a, b, c] : faces) {
    const Vector normal = cross(vertices[b] - vertices[a], vertices[c] - vertices[a]);
    if (!(dot(normal, vertices[a] - centre) > 0)) ++count;
  }
  return count;
}

/// True if the closed mesh winds around the point, from the crossings of the half line upwards (+z) from it.
/// A point on the surface counts as inside or outside, but as one of them: of meshes that tile space exactly
/// one has it.
inline bool isInside(const Point& point, Points vertices, Faces faces) {
  int winding = 0;
  Slice s;
  for (const auto& [a, b, c] : faces)
    if (slice(vertices[a], vertices[b], vertices[c], point.y, s) && s.meets(point.x) && s.heightAt(point.x) > point.z)
      winding += s.sign;
  return winding > 0;
}

}  // namespace morula
