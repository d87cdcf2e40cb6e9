#pragma once
// Planes, folds and momentum of cuts.
#include "division/cut.h"
#include "division/halves.h"
#include "unit/physics/lab.h"

namespace morula {

/// Returns the cut with this unit normal through the mean of a body's vertices.
inline Cut throughMean(const Body& body, const Vector& normal) { return {measureCentroid(body.position), normal}; }

/// Returns a body's momentum; all its vertices have the same mass. [mass·length/time]
inline Vector momentumOf(const Body& b) { return b.mass * measureCentroid(b.velocity); }

/// Returns the number of folded faces on a daughter's flat side. `b`: the daughter lies on the far side of the normal.
inline int foldsOf(const Body& daughter, const Body& mother, const Mesh& mesh, const Vector& normal, bool b) {
  const Point centre = measureCentroid(mother.position);
  std::vector<char> flat(mother.position.size());
  for (std::size_t v = 0; v < flat.size(); ++v) flat[v] = (dot(mother.position[v] - centre, normal) > 0) == b;
  return countFolds(daughter.position, mesh.faces, flat, b ? normal : -normal);
}

/// Returns the number of folds on both sides if nothing unfolds them.
inline int projectionFolds(const Body& mother, const Mesh& mesh, const Vector& normal) {
  const Point centre = measureCentroid(mother.position);
  Body projected = mother;
  for (Point& x : projected.position) x = x - dot(x - centre, normal) * normal;
  return foldsOf(projected, mother, mesh, normal, false) + foldsOf(projected, mother, mesh, normal, true);
}

}  // namespace morula
