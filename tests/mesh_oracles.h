#pragma once
// Measures of meshes that only tests need.
#include <algorithm>
#include <limits>

#include "mesh/measures.h"
#include "mesh/scan_line.h"

namespace morula {

/// How far the triangles are from equal and equilateral, which the springs and the contact radius assume.
struct Quality {
  double shortestEdge = 0, longestEdge = 0;  // [length]
  // Cosines, for angles would need a function whose bits differ between machines. An equilateral triangle has
  // 0.5.
  double sharpestCosine = 0;  // of the smallest angle of all faces: towards 1 for a needle [1]
  double bluntestCosine = 0;  // of the largest angle: towards −1 for a cap [1]
};

inline Quality measureQuality(Points vertices, Faces faces) {
  Quality q{std::numeric_limits<double>::infinity(), 0, -1, 1};
  for (const Face& face : faces)
    for (int k = 0; k < 3; ++k) {
      const Point& corner = vertices[face[k]];
      const Vector u = vertices[face[(k + 1) % 3]] - corner, v = vertices[face[(k + 2) % 3]] - corner;
      const double lengths = norm(u) * norm(v);
      // Two corners at one place: a needle without end.
      const double cosine = lengths > 0 ? dot(u, v) / lengths : 1;
      q.shortestEdge = std::min(q.shortestEdge, norm(u));
      q.longestEdge = std::max(q.longestEdge, norm(u));
      q.sharpestCosine = std::max(q.sharpestCosine, cosine);
      q.bluntestCosine = std::min(q.bluntestCosine, cosine);
    }
  return faces.empty() ? Quality{} : q;
}

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
